// SPDX-License-Identifier: MIT
#pragma once

// The version of engine and game. The build files and the packages read it from here.
#define KODO_VERSION_MAJOR 0
#define KODO_VERSION_MINOR 3
#define KODO_VERSION_PATCH 0
/// Compares as a number: 0.3.0 is 300, 1.3.5 would be 10305.
#define KODO_VERSION (KODO_VERSION_MAJOR * 10000 + KODO_VERSION_MINOR * 100 + KODO_VERSION_PATCH)
