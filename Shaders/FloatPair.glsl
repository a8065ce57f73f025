// SPDX-License-Identifier: BSD-3-Clause
// Numbers as unevaluated sums of two floats, of about 48 bits together: what takes double precision
// elsewhere, on devices that have none (Dekker 1971; Shewchuk 1997). Every operation rounds alone
// (`precise`): a product that is fused with a sum would lose what the low part is for. `low` is at most
// half a unit in the last place of `high`. Pair and Pair4 are in Layout.h.

struct Pair3
{
  vec3 high;
  vec3 low;
};

// a + b, exactly.
Pair4 twoSum(vec4 a, vec4 b)
{
  precise const vec4 sum = a + b;
  precise const vec4 part = sum - a;
  precise const vec4 rest = (a - (sum - part)) + (b - part);
  return Pair4(sum, rest);
}

// a + b, exactly, where a is the larger one.
Pair4 quickTwoSum(vec4 a, vec4 b)
{
  precise const vec4 sum = a + b;
  precise const vec4 rest = b - (sum - a);
  return Pair4(sum, rest);
}

// a * b, exactly: by halves of 12 bits, as a fused multiply-add may be none.
Pair4 twoProduct(vec4 a, vec4 b)
{
  precise const vec4 product = a * b;
  precise const vec4 bigA = 4097.0 * a;
  precise const vec4 highA = bigA - (bigA - a);
  precise const vec4 lowA = a - highA;
  precise const vec4 bigB = 4097.0 * b;
  precise const vec4 highB = bigB - (bigB - b);
  precise const vec4 lowB = b - highB;
  precise const vec4 rest =
    ((highA * highB - product) + highA * lowB + lowA * highB) + lowA * lowB;
  return Pair4(product, rest);
}

Pair4 add(Pair4 a, Pair4 b)
{
  const Pair4 sum = twoSum(a.high, b.high);
  const Pair4 rest = twoSum(a.low, b.low);
  precise const vec4 first = sum.low + rest.high;
  const Pair4 most = quickTwoSum(sum.high, first);
  precise const vec4 second = most.low + rest.low;
  return quickTwoSum(most.high, second);
}

Pair4 negative(Pair4 a) { return Pair4(-a.high, -a.low); }

Pair4 multiply(Pair4 a, Pair4 b)
{
  const Pair4 product = twoProduct(a.high, b.high);
  precise const vec4 rest = product.low + (a.high * b.low + a.low * b.high);
  return quickTwoSum(product.high, rest);
}

// 1 / a: a first quotient, and what it leaves over, divided once more.
Pair4 reciprocal(Pair4 a)
{
  precise const vec4 first = 1.0 / a.high;
  const Pair4 left = add(Pair4(vec4(1.0), vec4(0.0)), negative(multiply(Pair4(first, vec4(0.0)), a)));
  precise const vec4 second = left.high * first;
  return quickTwoSum(first, second);
}

Pair4 widen(Pair3 a) { return Pair4(vec4(a.high, 1.0), vec4(a.low, 0.0)); }
Pair4 spread(Pair a) { return Pair4(vec4(a.high), vec4(a.low)); }
Pair3 xyz(Pair4 a) { return Pair3(a.high.xyz, a.low.xyz); }
Pair3 add(Pair3 a, Pair3 b) { return xyz(add(widen(a), widen(b))); }
Pair3 negative(Pair3 a) { return Pair3(-a.high, -a.low); }
Pair3 multiply(Pair3 a, Pair b) { return xyz(multiply(widen(a), spread(b))); }

Pair x(Pair4 a) { return Pair(a.high.x, a.low.x); }
Pair reciprocal(Pair a) { return x(reciprocal(spread(a))); }
Pair add(Pair a, Pair b) { return x(add(spread(a), spread(b))); }
Pair negative(Pair a) { return Pair(-a.high, -a.low); }
Pair multiply(Pair a, Pair b) { return x(multiply(spread(a), spread(b))); }

// The sum of two floats.
Pair makePair(float a, float b) { return x(twoSum(vec4(a), vec4(b))); }
Pair makePair(float a) { return Pair(a, 0.0); }

bool isLess(Pair a, Pair b) { return a.high < b.high || (a.high == b.high && a.low < b.low); }
Pair greater(Pair a, Pair b)
{
  if (isLess(a, b))
  {
    return b;
  }
  return a;
}

Pair lesser(Pair a, Pair b)
{
  if (isLess(a, b))
  {
    return a;
  }
  return b;
}

// The sum of all four.
Pair sum(Pair4 a)
{
  const Pair4 two =
    add(Pair4(a.high.xyxy, a.low.xyxy), Pair4(a.high.zwzw, a.low.zwzw));
  return add(Pair(two.high.x, two.low.x), Pair(two.high.y, two.low.y));
}

// Scaled by a power of two, so that squares are in the range of floats.
Pair lengthOf(Pair3 vector)
{
  const float greatest =
    max(abs(vector.high.x), max(abs(vector.high.y), abs(vector.high.z)));
  int exponent;
  frexp(greatest, exponent);
  const float scale = ldexp(1.0, -exponent);
  const Pair3 a = Pair3(vector.high * scale, vector.low * scale);
  const Pair4 squares = multiply(widen(a), widen(a));
  const Pair square = add(add(Pair(squares.high.x, squares.low.x), Pair(squares.high.y, squares.low.y)),
    Pair(squares.high.z, squares.low.z));
  if (!(square.high > 0.0))
  {
    return Pair(0.0, 0.0);
  }
  // One step of Newton's from the root of the high part.
  const Pair root = Pair(sqrt(square.high), 0.0);
  const Pair left = add(square, negative(multiply(root, root)));
  precise const float rest = left.high / (2.0 * root.high);
  const Pair both = makePair(root.high, rest);
  return Pair(ldexp(both.high, exponent), ldexp(both.low, exponent));
}

Pair3 divide(Pair3 a, Pair b) { return multiply(a, reciprocal(b)); }
Pair divide(Pair a, Pair b) { return multiply(a, reciprocal(b)); }
