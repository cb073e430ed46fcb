# Mutants of axi_timer, one per rule of the AXI Timer v2.0.

# TCSR and its flag.
add_rtl_mutant(NAME timer_flag_cleared_by_zero FILE axi_timer/timer_channel.sv TEST axi_timer_channel_test
  FROM "if (tcsr_we_i && wstrb_i[1] && wdata_i[8]) tint_q"
  TO "if (tcsr_we_i && wstrb_i[1]) tint_q"
  KILLED_BY TimerChannelTest.WritingOneClearsTheFlagAndZeroKeepsIt)
add_rtl_mutant(NAME timer_clear_wins_over_a_wrap FILE axi_timer/timer_channel.sv TEST axi_timer_channel_test
  FROM "if (expires_o) tint_q"
  TO "if (expires_o && !(tcsr_we_i && wstrb_i[1] && wdata_i[8])) tint_q"
  KILLED_BY TimerChannelTest.AWrapWinsOverAClearInTheSameClock)
add_rtl_mutant(NAME timer_enit_gates_the_flag FILE axi_timer/timer_channel.sv TEST axi_timer_channel_test
  FROM "if (expires_o) tint_q"
  TO "if (expires_o && enit_q) tint_q"
  KILLED_BY TimerChannelTest.FlagIsSetWhetherOrNotTheInterruptIsEnabled)
add_rtl_mutant(NAME timer_enit_does_not_gate_the_pin FILE axi_timer/timer_channel.sv TEST axi_timer_channel_test
  FROM "interrupt_o = tint_q && enit_q;"
  TO "interrupt_o = tint_q;"
  KILLED_BY TimerChannelTest.FlagIsSetWhetherOrNotTheInterruptIsEnabled)
add_rtl_mutant(NAME timer_load_clears_itself FILE axi_timer/timer_channel.sv TEST axi_timer_channel_test
  FROM "      if (expires_o) tint_q"
  TO "      if (load_q) load_q <= 1'b0;
      if (expires_o) tint_q"
  KILLED_BY TimerChannelTest.LoadIsALevelThatStopsCountingAndIsNotSelfClearing)
add_rtl_mutant(NAME timer_pulse_without_gent FILE axi_timer/timer_channel.sv TEST axi_timer_channel_test
  FROM "(expires_o && gent_q) == GenAssert"
  TO "expires_o == GenAssert"
  KILLED_BY TimerChannelTest.GenerateOutNeedsGent)
add_rtl_mutant(NAME timer_interrupt_of_one_timer_only FILE axi_timer/timer_core.sv TEST axi_timer_test
  MODEL model_axi_timer
  FROM "irq_o <= interrupt0 || (interrupt1 && !casc_q);"
  TO "irq_o <= interrupt0;"
  KILLED_BY Stalls/AxiTimerTest.InterruptIsTheOrOfTheEnabledFlagsAndALevel/NoStall)

# Counting.
add_rtl_mutant(NAME timer_period_one_short FILE axi_timer/timer_counter.sv TEST axi_timer_channel_test
  FROM "count_o <= load_value_i;
        left_q  <= '0;"
  TO "count_o <= down_i ? load_value_i - 32'd1 : load_value_i + 32'd1;
        left_q  <= '0;"
  KILLED_BY TimerChannelTest.PeriodIsExactInBothDirections:TimerChannelTest.TickOf2500ClocksNeedsTlr2498)
add_rtl_mutant(NAME timer_period_one_long FILE axi_timer/timer_counter.sv TEST axi_timer_channel_test
  FROM "Show = 2'd1,"
  TO "Show = 2'd2,"
  KILLED_BY TimerChannelTest.PeriodIsExactInBothDirections:TimerChannelTest.TickOf2500ClocksNeedsTlr2498)
add_rtl_mutant(NAME timer_one_shot_restarts FILE axi_timer/timer_counter.sv TEST axi_timer_channel_test
  FROM "end else if (reload_i && !follow_i) begin"
  TO "end else if (!follow_i) begin"
  KILLED_BY TimerChannelTest.OneShotHoldsTheWrappedValueUntilLoad)
add_rtl_mutant(NAME timer_one_shot_ends_again_in_the_other_direction FILE axi_timer/timer_counter.sv
  TEST axi_timer_channel_test
  FROM "if (left_q != '0 && !free_i) begin
          reloads_o"
  TO "if (left_q != '0 && !free_i && !at_end) begin
          reloads_o"
  KILLED_BY TimerChannelTest.TurningAHeldOneShotRoundIsNoEvent)

# Capture.
add_rtl_mutant(NAME timer_capture_level FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM "trigger & ~trigger_q;"
  TO "trigger;"
  KILLED_BY AxiTimerCapture.OneClockIsLongEnoughAndALevelIsOneCapture)
add_rtl_mutant(NAME timer_capture_of_both_edges FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM "trigger & ~trigger_q;"
  TO "trigger ^ trigger_q;"
  KILLED_BY AxiTimerCapture.OneClockIsLongEnoughAndALevelIsOneCapture)
add_rtl_mutant(NAME timer_capture_not_synchronised FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM "trigger & ~trigger_q;"
  TO "(capture_trig_i ^ {!Trig1Assert, !Trig0Assert}) & ~trigger;"
  KILLED_BY AxiTimerCapture.StoresTheCountThreeClocksAfterThePinWasSampled)
add_rtl_mutant(NAME timer_capture_always_overwrites FILE axi_timer/timer_channel.sv TEST axi_timer_core_test
  FROM "armed && (arht_q || !tint_q);"
  TO "armed;"
  KILLED_BY AxiTimerCapture.WithoutArhtTheFirstCaptureStaysUntilTheFlagIsCleared)
add_rtl_mutant(NAME timer_capture_never_overwrites FILE axi_timer/timer_channel.sv TEST axi_timer_core_test
  FROM "armed && (arht_q || !tint_q);"
  TO "armed && !tint_q;"
  KILLED_BY AxiTimerCapture.WithArhtEveryCaptureOverwrites)
add_rtl_mutant(NAME timer_capture_while_stopped FILE axi_timer/timer_channel.sv TEST axi_timer_core_test
  FROM "armed      = ent_q && mdt_q"
  TO "armed      = mdt_q"
  KILLED_BY AxiTimerCapture.NeedsModeCaptureEnableAndRun)
add_rtl_mutant(NAME timer_capture_mode_has_periods FILE axi_timer/timer_channel.sv TEST axi_timer_core_test
  FROM ".free_i      (mdt_q)"
  TO ".free_i      (1'b0)"
  KILLED_BY AxiTimerCapture.RollOverIsNoEventAndTheCountRunsOn)
add_rtl_mutant(NAME timer_capture_pins_swapped FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM ".async_i(capture_trig_i ^"
  TO ".async_i({capture_trig_i[0], capture_trig_i[1]} ^"
  KILLED_BY AxiTimerCapture.EachTimerListensToItsOwnPin)

# ENALL and freeze.
add_rtl_mutant(NAME timer_enall_not_stored FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM "enall_q <= wdata_i[10];"
  TO "enall_q <= 1'b0;"
  KILLED_BY AxiTimerEnall.WritingOneToEitherTcsrSetsItAndEntInBoth:AxiTimerEnall.ReadModifyWriteStartsAgain)
add_rtl_mutant(NAME timer_enall_of_tcsr0_only FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM ".other_we_i    (tcsr1_we_i)"
  TO ".other_we_i    (1'b0)"
  KILLED_BY AxiTimerEnall.WritingOneToEitherTcsrSetsItAndEntInBoth:AxiTimerEnall.StartsBothOnOneEdge)
add_rtl_mutant(NAME timer_enall_zero_stops_both FILE axi_timer/timer_channel.sv TEST axi_timer_core_test
  FROM "if (wstrb_i[1] && wdata_i[10]) ent_q <= 1'b1;"
  TO "if (wstrb_i[1] && (wdata_i[10] || other_we_i)) ent_q <= wdata_i[10];"
  KILLED_BY AxiTimerEnall.WritingZeroClearsItAloneInBoth)
add_rtl_mutant(NAME timer_freeze_of_one_timer FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM ".freeze_i      (freeze),
    .capture_edge_i(trigger_edge_q[1])"
  TO ".freeze_i      (1'b0),
    .capture_edge_i(trigger_edge_q[1])"
  KILLED_BY AxiTimerFreeze.StopsAndContinuesBothCountersTwoClocksLater)

# Cascade.
add_rtl_mutant(NAME timer_cascade_ignored FILE axi_timer/timer_core.sv TEST axi_timer_test
  FROM "casc_q <= wdata_i[11];"
  TO "casc_q <= 1'b0;"
  KILLED_BY Stalls/AxiTimerDrivers.VendorInterrupt64BitExample/NoStall)
add_rtl_mutant(NAME timer_cascade_period_two_short FILE axi_timer/timer_counter.sv TEST axi_timer_core_test
  FROM "ShowCascade = 2'd3;"
  TO "ShowCascade = 2'd1;"
  KILLED_BY AxiTimerCascade.PeriodIsTheLoadValuePlusFour)
add_rtl_mutant(NAME timer_cascade_reloads_the_lower_half_only FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM "reloads0 ? casc_q || (pwm"
  TO "reloads0 ? (pwm"
  KILLED_BY AxiTimerCascade.PeriodIsTheLoadValuePlusFour)
add_rtl_mutant(NAME timer_cascade_event_at_each_carry FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM ".lower_i       (casc_q)"
  TO ".lower_i       (1'b0)"
  KILLED_BY AxiTimerCascade.CountsSixtyFourBitsAcrossTheCarry)
add_rtl_mutant(NAME timer_cascade_own_direction FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM ".upper_down_i  (down0)"
  TO ".upper_down_i  (1'b1)"
  KILLED_BY AxiTimerCascade.CountsSixtyFourBitsAcrossTheCarry)
add_rtl_mutant(NAME timer_cascade_captures_the_lower_half_only FILE axi_timer/timer_channel.sv TEST axi_timer_core_test
  FROM "if (capture_too_i) tlr_o <= tcr_o;"
  TO "if (1'b0) tlr_o <= tcr_o;"
  KILLED_BY AxiTimerCascade.CaptureStoresBothHalvesByThePinOfTimer0)

add_rtl_mutant(NAME timer_cascade_interrupts_for_timer1_too FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM "(interrupt1 && !casc_q);"
  TO "interrupt1;"
  KILLED_BY AxiTimerCascade.AFlagThatTimer1HasFromBeforeRaisesNoInterrupt)

# PWM.
add_rtl_mutant(NAME timer_pwm_clear_does_not_win FILE axi_timer/timer_pwm.sv TEST axi_timer_core_test
  FROM "(expired_q || !high_runs_i);"
  TO "(expired_q || high_ends_i || !high_runs_i);"
  KILLED_BY AxiTimerPwm.AnEndOfTimer1WinsOverAnEndOfTimer0)
add_rtl_mutant(NAME timer_pwm_set_by_every_period FILE axi_timer/timer_pwm.sv TEST axi_timer_core_test
  FROM "period_ends_i && (expired_q || !high_runs_i);"
  TO "period_ends_i;"
  KILLED_BY AxiTimerPwm.PeriodAndHighTimeAreExact)
add_rtl_mutant(NAME timer_pwm_never_constant_one FILE axi_timer/timer_pwm.sv TEST axi_timer_core_test
  FROM "(expired_q || !high_runs_i);"
  TO "expired_q;"
  KILLED_BY AxiTimerPwm.OnlyTimer0RunningIsConstantOne)
add_rtl_mutant(NAME timer_pwm_too_long_a_pulse_goes_on FILE axi_timer/timer_pwm.sv TEST axi_timer_core_test
  FROM "period_ends_i && (expired_q || !high_runs_i);"
  TO "period_ends_i && (expired_q || !high_runs_i || (pwm_o && !high_ends_i));"
  KILLED_BY AxiTimerPwm.AHighTimeBeyondThePeriodWrittenWhileItRunsIsConstantZero)
add_rtl_mutant(NAME timer_pwm_leaves_constant_one_by_a_dark_period FILE axi_timer/timer_pwm.sv TEST axi_timer_core_test
  FROM "expired_q <= !period_ends_i || !high_runs_i;"
  TO "expired_q <= !period_ends_i;"
  KILLED_BY AxiTimerPwm.LeavingConstantOneSkipsNoPulse)
add_rtl_mutant(NAME timer_pwm_leaves_constant_one_dark_if_both_end FILE axi_timer/timer_pwm.sv TEST axi_timer_core_test
  FROM "period_ends_i && (expired_q"
  TO "period_ends_i && !high_ends_i && (expired_q"
  KILLED_BY AxiTimerPwm.LeavingConstantOneSkipsNoPulse)
add_rtl_mutant(NAME timer_pwm_timer1_free_running FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM "casc_q || (pwm_mode_q && ent1)"
  TO "casc_q"
  KILLED_BY AxiTimerPwm.PeriodAndHighTimeAreExact:AxiTimerPwm.Timer1HoldsItsWrappedValueAndReloadsWithTimer0)
add_rtl_mutant(NAME timer_pwm_timer1_waits_for_a_stopped_timer0 FILE axi_timer/timer_core.sv TEST axi_timer_test
  FROM ".follow_i      (pwm_mode_q && ent0)"
  TO ".follow_i      (pwm_mode_q)"
  KILLED_BY Stalls/AxiTimerDrivers.ZephyrPwmDutyCyclesAreExactAfterEveryOtherOne/NoStall)
add_rtl_mutant(NAME timer_pwm_restarts_a_stopped_timer1 FILE axi_timer/timer_core.sv TEST axi_timer_lockstep_test
  FROM "(pwm_mode_q && ent1) : 1'b0"
  TO "pwm_mode_q : 1'b0"
  KILLED_BY AxiTimerLockstep.RandomTrafficIsThatOfTheModelInEveryClock)
add_rtl_mutant(NAME timer_pwm_without_pwmb FILE axi_timer/timer_core.sv TEST axi_timer_core_test
  FROM "ready0 && ready1 && !casc_q;"
  TO "ready0 && !casc_q;"
  KILLED_BY AxiTimerPwm.NeedsBothPwmBitsBothPulsesAndGenerateMode)
add_rtl_mutant(NAME timer_pwm_in_a_cascade FILE axi_timer/timer_core.sv TEST axi_timer_lockstep_test
  FROM "ready0 && ready1 && !casc_q;"
  TO "ready0 && ready1;"
  KILLED_BY AxiTimerLockstep.RandomTrafficIsThatOfTheModelInEveryClock)
add_rtl_mutant(NAME timer_tcr_write_is_okay FILE axi_timer/axi_timer_reg_top.sv TEST axi_timer_test
  FROM "        16'h0014: ;  // TLR1: kept by the core
        default"
  TO "        16'h0014: ;  // TLR1: kept by the core
        16'h0008: ;
        default"
  KILLED_BY Stalls/AxiTimerTest.UnmappedAndReadOnlyRegistersAnswerSlvErr/NoStall)
