// SPDX-License-Identifier: BSD-3-Clause
// Empty: CMake attaches the precompiled headers of the tests to this source.
