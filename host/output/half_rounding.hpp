// SPDX-License-Identifier: Apache-2.0
// What 16-bit floats lose of values (IEEE 754, binary16, to nearest).
#pragma once

namespace gonio::half_rounding {

inline constexpr double least_normal = 0x1p-14;
inline constexpr double relative = 0x1p-11;  ///< at most, of values from there on
inline constexpr double absolute = 0x1p-25;  ///< at most, of values below

}  // namespace gonio::half_rounding
