// SPDX-License-Identifier: MIT
// Intentionally empty: the target only precompiles headers.
