# Broken copies of axi_uart16550. The first ones pass every example of AMD's driver.

# Registers and interrupts.
add_rtl_mutant(NAME uart_no_fcr_read_back FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "iir_re_i ? (dlab ? {trigger_q"
  TO "iir_re_i ? (1'b0 ? {trigger_q"
  KILLED_BY */UartRegisters.FcrReadsBackWithDlab/*:*/UartVendorDriver.FifoThresholdSurvivesOptions/*)
add_rtl_mutant(NAME uart_no_thre_on_enable FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "assign thre_enabled      = ier_we_i ? "
  TO "assign thre_enabled      = 1'b0 ? "
  KILLED_BY */UartInterrupts.EnablingThreWhileEmptyRaisesItEachTime/*:*/UartLinuxDriver.StartupFindsNoBugs/*)
add_rtl_mutant(NAME uart_every_fcr_write_flushes FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "assign rx_flush = iir_we_i ? "
  TO "assign rx_flush = iir_we_i ? 1'b1 || "
  KILLED_BY */UartRegisters.OnlyTheEnableBitAndTheFlushBitsFlush/*)
add_rtl_mutant(NAME uart_flush_without_enable FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "(wdata_i[0] && wdata_i[1])"
  TO "wdata_i[1]"
  KILLED_BY */UartRegisters.OnlyTheEnableBitAndTheFlushBitsFlush/*)
add_rtl_mutant(NAME uart_iir_read_keeps_thre FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "tx_push || (iir_re_i && !dlab && source == 4'h2)"
  TO "tx_push"
  KILLED_BY */UartInterrupts.EnablingThreWhileEmptyRaisesItEachTime/*:*/UartRandom.*)
add_rtl_mutant(NAME uart_every_iir_read_clears_thre FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "tx_push || (iir_re_i && !dlab && source == 4'h2)"
  TO "tx_push || (iir_re_i && !dlab)"
  KILLED_BY */UartInterrupts.ThreIsAcknowledgedOnlyByTheReadThatReturnsIt/*:*/UartRandom.*)
add_rtl_mutant(NAME uart_thr_write_keeps_thre FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "tx_push || (iir_re_i && !dlab && source == 4'h2)"
  TO "(iir_re_i && !dlab && source == 4'h2)"
  KILLED_BY */UartInterrupts.ThreIsClearedByWritingAndRaisedByTheLastCharacterTaken/*)
add_rtl_mutant(NAME uart_thre_with_every_character FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "thre_irq_q <= tx_empties || thre_enabled;"
  TO "thre_irq_q <= tx_take || tx_empties || thre_enabled;
    end else if (tx_take) begin
      thre_irq_q <= 1'b1;"
  KILLED_BY */UartInterrupts.ThreIsClearedByWritingAndRaisedByTheLastCharacterTaken/*)
add_rtl_mutant(NAME uart_out2_gates_the_line FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "irq_o <= source != 4'h1;"
  TO "irq_o <= source != 4'h1 && mcr_i[3];"
  KILLED_BY */UartInterrupts.ModemControlDoesNotGateTheLine/*)
add_rtl_mutant(NAME uart_modem_change_unnoticed FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "timeout_tick || tx_take || modem_event : 1'b0;"
  TO "timeout_tick || tx_take : 1'b0;"
  KILLED_BY */UartRegisters.ModemInputsReportTheirChangesOnce/*:*/UartRandom.*)
add_rtl_mutant(NAME uart_fcr_bits_without_enable FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "if (wdata_i[0]) {trigger_q"
  TO "{trigger_q"
  KILLED_BY */UartRegisters.FcrReadsBackWithDlab/*)
add_rtl_mutant(NAME uart_dll_read_takes_a_character FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "assign rx_pop = rbr_re_i && !dlab;"
  TO "assign rx_pop = rbr_re_i;"
  KILLED_BY */UartRegisters.DlabSwapsTheDivisorInAndTouchesNothingElse/*)
add_rtl_mutant(NAME uart_byte_strobe_ignored FILE axi_uart16550/axi_uart16550.sv TEST axi_uart16550_test
  FROM "rbr_we && reg_wstrb[0]"
  TO "rbr_we"
  KILLED_BY */UartRegisters.AWriteCountsOnlyWithByteZero/*)
add_rtl_mutant(NAME uart_low_words_unmapped FILE axi_uart16550/axi_uart16550.sv TEST axi_uart16550_test
  FROM "(reg_waddr[15:12] == '0 ? 16'd0 : reg_waddr)"
  TO "(reg_waddr)"
  KILLED_BY */UartRegisters.WordsBelowTheRegistersReadZeroAndIgnoreWrites/*)
add_rtl_mutant(NAME uart_divisor_zero_runs FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "baud_on_q      <= {divisor_q[15:8], wdata_i} != '0;"
  TO "baud_on_q      <= 1'b1;"
  KILLED_BY */UartRegisters.TheDivisorIsZeroWhicheverByteIsWrittenLast/*)
add_rtl_mutant(NAME uart_divisor_zero_runs_by_its_high_byte FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "baud_on_q       <= {wdata_i, divisor_q[7:0]} != '0;"
  TO "baud_on_q       <= 1'b1;"
  KILLED_BY */UartRegisters.TheDivisorIsZeroWhicheverByteIsWrittenLast/*:*/UartRegisters.DivisorZero*)
add_rtl_mutant(NAME uart_old_divisor_counts_on FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "tx_take || baud_loaded_q"
  TO "tx_take"
  KILLED_BY */UartTransmit.ANewDivisorTakesEffectAtOnce/*)
add_rtl_mutant(NAME uart_stale_rbr FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "rx_waiting ? rx_top : 8'd0"
  TO "rx_top"
  KILLED_BY */UartReceive.ReadingTakesExactlyOneCharacter/*)

# FIFOs and loopback.
add_rtl_mutant(NAME uart_fifteen_deep FILE axi_uart16550/uart_fifo.sv TEST axi_uart16550_test
  FROM "level_o == 5'(Depth);"
  TO "level_o == 5'd15;"
  KILLED_BY */UartTransmit.FifoHoldsSixteen*:*/UartReceive.OverrunKeeps*:*/UartLinuxDriver.FifoSizeIsSixteen/*)
add_rtl_mutant(NAME uart_overrun_overwrites FILE axi_uart16550/uart_fifo.sv TEST axi_uart16550_test
  FROM "replaces  = overrun_o && single_i;"
  TO "replaces  = overrun_o;"
  KILLED_BY */UartReceive.OverrunKeepsSixteenAndLosesTheNewest/*)
add_rtl_mutant(NAME uart_holding_register_keeps_the_old FILE axi_uart16550/uart_fifo.sv TEST axi_uart16550_test
  FROM "replaces  = overrun_o && single_i;"
  TO "replaces  = 1'b0;"
  KILLED_BY */UartReceive.WithoutFifoAnOverrunKeepsTheNewest/*:*/UartTransmit.WithoutFifoAWriteReplaces*:*/UartRandom.*)
add_rtl_mutant(NAME uart_flush_is_silent FILE axi_uart16550/uart_fifo.sv TEST axi_uart16550_test
  FROM "(flush_i || (pops &&"
  TO "((pops &&"
  KILLED_BY */UartInterrupts.FlushingCharactersRaisesThreAndFlushingNothingDoesNot/*)
add_rtl_mutant(NAME uart_data_before_the_transmitter_is_empty FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "(loops && tx_busy && !tx_done)"
  TO "(1'b0)"
  KILLED_BY */UartVendorDriver.PolledExample/*:*/UartLoopback.ACharacterArrivesWhenTheTransmitterIsEmpty/*)
add_rtl_mutant(NAME uart_data_a_clock_after_the_transmitter FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "(loops && tx_busy && !tx_done)"
  TO "(loops && tx_busy)"
  KILLED_BY */UartLoopback.ACharacterArrivesWhenTheTransmitterIsEmpty/*)
add_rtl_mutant(NAME uart_loopback_on_the_pin FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "txd_o <= loops || ("
  TO "txd_o <= ("
  KILLED_BY */UartLoopback.PinsAreIdleAndIgnored/*)
add_rtl_mutant(NAME uart_break_in_loopback FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "(loops ? tx_serial : rxd)"
  TO "(loops ? tx_serial && !lcr_i[6] : rxd)"
  KILLED_BY */UartLoopback.BreakActsOnThePinOnly/*)

# Transmitter.
add_rtl_mutant(NAME uart_transmitter_empty_too_soon FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "tx_level == '0 && !tx_busy, tx_level"
  TO "tx_level == '0, tx_level"
  KILLED_BY */UartTransmit.EmptyFlagsFollowTheLine/*)
add_rtl_mutant(NAME uart_two_stop_bits_after_five FILE axi_uart16550/uart_tx.sv TEST axi_uart16550_test
  FROM "5'd23"
  TO "5'd31"
  KILLED_BY */UartTransmit.EveryFormatIsExactOnTheLineWithoutGaps/*)
add_rtl_mutant(NAME uart_stop_bit_changes_under_way FILE axi_uart16550/uart_tx.sv TEST axi_uart16550_test
  FROM "ticks_q    <= stop_q;"
  TO "ticks_q    <= stop_i ? 5'd31 : 5'd15;"
  KILLED_BY */UartTransmit.ACharacterKeepsTheFormatItBeganWith/*)
add_rtl_mutant(NAME uart_bit_a_clock_long FILE axi_uart16550/uart_baud.sv TEST axi_uart16550_test
  FROM "count_q <= divisor_i - 16'd1;"
  TO "count_q <= divisor_i;"
  KILLED_BY */UartTransmit.ABitIsSixteenDivisorsLong/*)

# Receiver.
add_rtl_mutant(NAME uart_glitch_starts FILE axi_uart16550/uart_rx.sv TEST axi_uart16550_test
  FROM "state_q <= level ? Idle : Bits;"
  TO "state_q <= Bits;"
  KILLED_BY */UartReceive.AGlitchIsNoStartBit/*)
add_rtl_mutant(NAME uart_one_sample FILE axi_uart16550/uart_rx.sv TEST axi_uart16550_test
  FROM "assign level  = middle ? ("
  TO "assign level  = line_i; logic unused; assign unused = middle ? ("
  KILLED_BY */UartReceive.SeventhToNinthSixteenthDecideABit/*)
add_rtl_mutant(NAME uart_samples_early FILE axi_uart16550/uart_rx.sv TEST axi_uart16550_test
  FROM "ticks_q == 4'd8"
  TO "ticks_q == 4'd5"
  KILLED_BY */UartReceive.FourAndAHalfPercentOffIsStillRead/*)
add_rtl_mutant(NAME uart_stick_parity_ignored FILE axi_uart16550/uart_rx.sv TEST axi_uart16550_test
  FROM "(stick_q ? !even_q : (^data_o) ^ !even_q)"
  TO "((^data_o) ^ !even_q)"
  KILLED_BY */UartReceive.ParityErrorsOfEveryKind/*)
add_rtl_mutant(NAME uart_endless_breaks FILE axi_uart16550/uart_rx.sv TEST axi_uart16550_test
  FROM "state_q <= stop_q ? Idle : AwaitHigh;"
  TO "state_q <= Idle;"
  KILLED_BY */UartReceive.BreakIsOneZeroCharacterUntilTheLineIsHigh/*)
add_rtl_mutant(NAME uart_reset_line_starts FILE axi_uart16550/uart_rx.sv TEST axi_uart16550_test
  FROM "state_q  <= AwaitHigh;"
  TO "state_q  <= Idle;"
  KILLED_BY */UartReceive.ALineThatIsLowAtResetIsNoCharacter/*)
add_rtl_mutant(NAME uart_trigger_off_by_one FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "iir_re_i ? (fifo_on_q ? rx_level >= trigger"
  TO "iir_re_i ? (fifo_on_q ? rx_level > trigger"
  KILLED_BY */UartReceive.DataInterruptAtTheTriggerLevel/*:*/UartRandom.*)
add_rtl_mutant(NAME uart_timeout_of_three FILE axi_uart16550/uart_rx_status.sv TEST axi_uart16550_test
  FROM "<< 6) -"
  TO "* 10'd48) -"
  KILLED_BY */UartReceive.TimeoutAfterFourCharacterTimes/*)
add_rtl_mutant(NAME uart_read_does_not_restart_the_timeout FILE axi_uart16550/uart_rx_status.sv TEST axi_uart16550_test
  FROM "fifo_on_i && (arrives_i || pop_i)"
  TO "fifo_on_i && arrives_i"
  KILLED_BY */UartReceive.AReadRestartsTheTimeout/*)
add_rtl_mutant(NAME uart_character_does_not_restart_the_timeout FILE axi_uart16550/uart_rx_status.sv TEST axi_uart16550_test
  FROM "fifo_on_i && (arrives_i || pop_i)"
  TO "fifo_on_i && (pop_i || (arrives_i && !waiting_i))"
  KILLED_BY */UartReceive.ACharacterRestartsTheTimeout/*)
add_rtl_mutant(NAME uart_character_ends_the_timeout FILE axi_uart16550/uart_rx_status.sv TEST axi_uart16550_test
  FROM "if (pop_i || flush_i) timeout_o"
  TO "if (pop_i || flush_i || arrives_i) timeout_o"
  KILLED_BY */UartReceive.TimeoutAfterFourCharacterTimes/*:*/UartRandom.*)
add_rtl_mutant(NAME uart_waiting_errors_unseen FILE axi_uart16550/uart_rx_status.sv TEST axi_uart16550_test
  FROM "(bad_q != '0 || errors_q[3:1] != '0)"
  TO "(lsr_errors_o[3:1] != '0)"
  KILLED_BY */UartReceive.ErrorsTravelWithTheirCharacter/*:*/UartRandom.*)
add_rtl_mutant(NAME uart_overrun_lost_to_a_read FILE axi_uart16550/uart_rx_status.sv TEST axi_uart16550_test
  FROM "(lsr_read_i ? 4'b0 : lsr_errors_o) | {3'b0, overrun_i}"
  TO "lsr_read_i ? 4'b0 : lsr_errors_o | {3'b0, overrun_i}"
  KILLED_BY */UartReceive.AnErrorThatMeetsTheReadIsReportedOnce/*)

# Modem lines.
add_rtl_mutant(NAME uart_change_lost_to_a_read FILE axi_uart16550/uart_modem.sv TEST axi_uart16550_test
  FROM "(msr_read_i ? 4'b0 : changes_q) | changes"
  TO "msr_read_i ? 4'b0 : changes_q | changes"
  KILLED_BY */UartRegisters.AChangeThatMeetsTheReadIsNotLost/NoStall)
add_rtl_mutant(NAME uart_ring_counts_twice FILE axi_uart16550/uart_modem.sv TEST axi_uart16550_test
  FROM "{1'b1, lines_q[2], 2'b11}"
  TO "4'hF"
  KILLED_BY */UartRegisters.ModemInputsReportTheirChangesOnce/*:*/UartRandom.*)
add_rtl_mutant(NAME uart_reset_is_a_modem_change FILE axi_uart16550/uart_modem.sv TEST axi_uart16550_test
  FROM "filling_q <= '1;"
  TO "filling_q <= '0;"
  KILLED_BY */UartRegisters.ResetTakesTheModemLinesAsTheyAre/*)

# Sleep.
add_rtl_mutant(NAME uart_sleeps_through_a_modem_change FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "{rxd_i, modem_i} != pins_q;"
  TO "rxd_i != pins_q[4];"
  KILLED_BY */UartRegisters.ModemInputsReportTheirChangesOnce/*:*/UartRandom.*)
add_rtl_mutant(NAME uart_sleeps_before_the_timeout FILE axi_uart16550/uart_core.sv TEST axi_uart16550_test
  FROM "rx_fresh || timing || changed_q"
  TO "rx_fresh || changed_q"
  KILLED_BY */UartReceive.TimeoutAfterFourCharacterTimes/*)
add_rtl_mutant(NAME uart_sleeps_into_a_character FILE axi_uart16550/uart_rx.sv TEST axi_uart16550_test
  FROM "state_q == Idle && !start_o;"
  TO "state_q == Idle;"
  KILLED_BY */UartReceive.ACharacterRightAfterAGlitchIsReceived/*)
