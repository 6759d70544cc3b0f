// SPDX-License-Identifier: MIT
// Nothing: the headers that its target precompiles are what it is for.
