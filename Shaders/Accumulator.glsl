// SPDX-License-Identifier: BSD-3-Clause
// What a ray has gathered, of which each way of blending uses a part; compilers drop the rest.
struct Accumulator
{
  vec4 color;         // Composite: premultiplied; Sum: the first component is the integral
  TransferPoint last; // of the value at which the ray is, where the field is continuous
  float value;        // Extremum: the greatest or least so far; Slice: any, where it is there
  float counted;      // Sum: on which values count, in unit distances
#ifdef FAMILY_COMPONENTS
  vec4 values; // Extremum, of each component
  vec4 sums;   // Sum: of each function of opacity
  vec4 counts;
#endif
};
