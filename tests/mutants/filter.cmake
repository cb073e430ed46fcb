# Broken debounce filters in up/down mode.

add_rtl_mutant(NAME up_down_restarts FILE common/debounce.sv TEST debounce_test
  FROM "counting_q & ~counts & {Lines{mode_i}};"
  TO "{Lines{1'b0}};"
  KILLED_BY DebounceUpDown.ChatterDelays*:DebounceUpDown.TreatsEveryLineAsASaturatingCounterDoes)
add_rtl_mutant(NAME restart_counts_down FILE common/debounce.sv TEST debounce_test
  FROM "counting_q & ~counts & {Lines{mode_i}};"
  TO "counting_q & ~counts;"
  KILLED_BY Debounce.ChatterRestartsTheCount:DebounceUpDown.ChatterDelays*)
add_rtl_mutant(NAME up_down_holds_its_count FILE common/debounce.sv TEST debounce_test
  FROM "      carry = moves;"
  TO "      carry = moves & ~down;"
  KILLED_BY DebounceUpDown.TreatsEveryLineAsASaturatingCounterDoes)
add_rtl_mutant(NAME up_down_borrow_as_carry FILE common/debounce.sv TEST debounce_test
  FROM "carry = carry & (count_q[k] ^ down);"
  TO "carry = carry & count_q[k];"
  KILLED_BY DebounceUpDown.TreatsEveryLineAsASaturatingCounterDoes)
add_rtl_mutant(NAME glitch_before_the_count_is_back FILE common/debounce.sv TEST debounce_test
  FROM "counting_q & ~differs & ~left;"
  TO "counting_q & ~differs;"
  KILLED_BY DebounceUpDown.NoiseOnARestingLineMovesNothingAndCountsOneGlitchAVisit)
add_rtl_mutant(NAME unknown_line_follows_every_sample FILE common/debounce.sv TEST debounce_test
  FROM "(done | ~(known_o | down))"
  TO "(done | ~known_o)"
  KILLED_BY DebounceUpDown.AdoptsTheMajorityLevelSilently)
add_rtl_mutant(NAME filter_mode_not_connected FILE encoder/encoder.sv TEST encoder_registers_test
  FROM ".filter_mode_i   (filter_mode)"
  TO ".filter_mode_i   (1'b0)"
  KILLED_BY Stalls/EncoderRegisters.FilterModeIsSettable/*)
add_rtl_mutant(NAME ranges_of_a_longer_filter FILE common/debounce.sv TEST encoder_test
  FROM "time_i - 8'd1"
  TO "time_i"
  KILLED_BY EncoderFilter.CleanLines*:EncoderFilter.OneBadSample*)
add_rtl_mutant(NAME ranges_without_up_down FILE common/debounce.sv TEST encoder_test
  FROM "counting_q & ~counts & {Lines{mode_i}};"
  TO "{Lines{1'b0}};"
  KILLED_BY EncoderFilter.OneBadSample*)
