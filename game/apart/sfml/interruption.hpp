// SPDX-License-Identifier: MIT
#pragma once

namespace apart {

/// From now on, a signal that asks the program to end (SIGINT, SIGTERM, SIGHUP) is noted instead,
/// so that the running game can be kept. One that is ignored, as by nohup, stays so.
void watchForInterruption();

/// True once such a signal has arrived.
bool isInterrupted();

} // namespace apart
