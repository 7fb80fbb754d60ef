#pragma once

/// What the board's one interrupt handler calls.
namespace spanline::board {

/// Alarm 0 of the timer, which ends a delay.
void timer_alarm();

/// The end of a band's transfer.
void band_sent();

}  // namespace spanline::board
