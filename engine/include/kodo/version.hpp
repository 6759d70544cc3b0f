// SPDX-License-Identifier: MIT
#pragma once

// The version of engine and game. The build files and the packages read it from here.
#define KODO_VERSION_MAJOR 0
#define KODO_VERSION_MINOR 2
#define KODO_VERSION_PATCH 0
/// Compares as a number: 0.2.0 is 200, 1.3.5 would be 10305.
#define KODO_VERSION (KODO_VERSION_MAJOR * 10000 + KODO_VERSION_MINOR * 100 + KODO_VERSION_PATCH)
