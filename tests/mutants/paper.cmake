# Broken blocks of the paper's fabric.

add_rtl_mutant(NAME width_one_cycle_long FILE pulse_width/pulse_width_gen.sv TEST pulse_width_test
  FROM "if (left_q == 32'd1) begin"
  TO "if (left_q == 32'd0) begin"
  KILLED_BY PulseWidth.TogglesEveryWidthCycles*:PulseWidth.ReachesSixtyFourOfTwoHundredCounts)
add_rtl_mutant(NAME width_runs_on_over_the_trigger FILE pulse_width/pulse_width_gen.sv TEST pulse_width_test
  FROM "      left_q    <= magnitude(width_i);"
  TO "      left_q    <= running_q ? left_q : magnitude(width_i);"
  KILLED_BY PulseWidth.TogglesEveryWidthCycles*)
add_rtl_mutant(NAME width_high_pulse_survives_the_trigger FILE pulse_width/pulse_width_gen.sv TEST pulse_width_test
  FROM "trigger_i && !stop_i) begin
      step_o    <= 1'b0;"
  TO "trigger_i && !stop_i) begin
      step_o    <= step_o;"
  KILLED_BY PulseWidth.TriggerCutsAPulseThatIsStillHigh)
add_rtl_mutant(NAME width_taken_at_once FILE pulse_width/pulse_width_gen.sv TEST pulse_width_test
  FROM "        left_q <= width_q;"
  TO "        left_q <= magnitude(width_i);"
  KILLED_BY PulseWidth.NewWidthWaitsForTheTriggerAndStandsUntilTheNext)
add_rtl_mutant(NAME width_sign_ignored_by_the_count FILE pulse_width/pulse_width_gen.sv TEST pulse_width_test
  FROM "emitted_o <= dir_o ? emitted_o + 32'sd1 : emitted_o - 32'sd1;"
  TO "emitted_o <= emitted_o + 32'sd1;"
  KILLED_BY PulseWidth.EmittedIsWhatTheDrivesCountedAtTheTrigger)
add_rtl_mutant(NAME width_rises_in_the_stop_cycle FILE pulse_width/pulse_width_gen.sv TEST pulse_width_test
  FROM "step_o <= !step_o && running_q && !stop_i;
        if (!step_o && running_q && !stop_i)"
  TO "step_o <= !step_o && running_q;
        if (!step_o && running_q)"
  KILLED_BY PulseWidth.StopAllowsNoFurtherRiseAndEndsAHighPulseAtItsWidth)
add_rtl_mutant(NAME width_stop_cuts_the_pulse FILE pulse_width/pulse_width_gen.sv TEST pulse_width_test
  FROM "      if (stop_i) running_q <= 1'b0;"
  TO "      if (stop_i) running_q <= 1'b0;
      if (stop_i) step_o <= 1'b0;"
  KILLED_BY PulseWidth.StopAllowsNoFurtherRiseAndEndsAHighPulseAtItsWidth)
add_rtl_mutant(NAME width_stays_armed FILE pulse_width/pulse_width_core.sv TEST pulse_width_test
  FROM "(!rst_ni || stopped) armed_o"
  TO "(!rst_ni) armed_o"
  KILLED_BY PulseWidth.OldWidthsDoNotStartTheArmAfterAStop)
add_rtl_mutant(NAME width_emitted_live FILE pulse_width/pulse_width_core.sv TEST pulse_width_test
  FROM "end else if (trigger_i) begin"
  TO "end else begin"
  KILLED_BY PulseWidth.EmittedIsWhatTheDrivesCountedAtTheTrigger)

add_rtl_mutant(NAME switch_lines_of_two_encoders FILE encoder_switch/encoder_switch.sv TEST encoder_switch_test
  FROM "enc_b_i[select]"
  TO "enc_b_i[select ^ 3'd1]"
  KILLED_BY Stalls/EncoderSwitchRegisters.PassesTheLines*:OneDecoder.CountsOfDeselectedEncodersAreLost)
add_rtl_mutant(NAME switch_none_is_the_first FILE encoder_switch/encoder_switch.sv TEST encoder_switch_test
  FROM "enc_a_i[select] && select < 3'd6;"
  TO "select < 3'd6 ? enc_a_i[select] : enc_a_i[0];"
  KILLED_BY Stalls/EncoderSwitchRegisters.PassesTheLines*:OneDecoder.NoSelectedEncoderMeansLowLines)
add_rtl_mutant(NAME single_decoder_says_six_axes FILE encoder/encoder.sv TEST encoder_switch_test
  MODEL model_encoder_single
  FROM "8'(Axes)}"
  TO "8'd6}"
  KILLED_BY OneDecoder.SaysThatItHasOneAxis)
