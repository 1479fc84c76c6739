#include "bem/algebra/DoubledSums.hpp"

#include "bem/simd/Dispatch.hpp"

// Compiled without contraction: a fused sum would not be the one whose error is taken.

namespace epafi::bem {

namespace {

struct Halves {
  double high;
  double low;
  explicit Halves(long double x)
      : high(static_cast<double>(x)), low(static_cast<double>(x - high)) {}
};

EPAFI_INLINE void fetch(const double* from, Index count, Pack& to) {
  if (count >= lanes) {
    __builtin_memcpy(&to, from, sizeof to);
    return;
  }
  to = Pack{};
  for (int lane = 0; lane < count; ++lane)
    to[lane] = from[lane];
}

EPAFI_INLINE void put(const Pack& from, Index count, double* to) {
  if (count >= lanes)
    __builtin_memcpy(to, &from, sizeof from);
  else
    for (int lane = 0; lane < count; ++lane)
      to[lane] = from[lane];
}

/// (high, low) += a (x + y), where y is small: the error of the product from a fused one, that
/// of the sum from its parts.             [Ogita, Rump & Oishi 2005, TwoProductFMA, TwoSum]
EPAFI_INLINE void addProduct(const Pack& a, const Pack& x, const Pack& y, Pack& high,
                             Pack& low) {
  const Pack product = a * x;
  Pack error;
  for (int lane = 0; lane < lanes; ++lane)
    error[lane] = __builtin_fma(a[lane], x[lane], -product[lane]);
  const Pack sum = high + product;
  const Pack part = sum - high;
  low += ((high - (sum - part)) + (product - part)) + (error + a * y);
  high = sum;
}

struct Dot {
  const double* a;
  const double* high;
  const double* low;
  Index size;
  long double& result;

  template <Division>
  EPAFI_INLINE void run() const {
    Pack sum{};
    Pack rest{};
    for (Index i = 0; i < size; i += lanes) {
      Pack factor;
      Pack x;
      Pack y;
      fetch(a + i, size - i, factor);
      fetch(high + i, size - i, x);
      fetch(low + i, size - i, y);
      addProduct(factor, x, y, sum, rest);
    }
    double whole = 0;
    double left = 0;
    for (int lane = 0; lane < lanes; ++lane) {
      const double next = whole + sum[lane];
      const double part = next - whole;
      left += ((whole - (next - part)) + (sum[lane] - part)) + rest[lane];
      whole = next;
    }
    result = static_cast<long double>(whole) + left;
  }
};

struct AddMultiple {
  Halves factor;
  const double* a;
  double* high;
  double* low;
  Index size;

  template <Division>
  EPAFI_INLINE void run() const {
    const Pack x = Pack{} + factor.high;
    const Pack y = Pack{} + factor.low;
    for (Index i = 0; i < size; i += lanes) {
      Pack entries;
      Pack sum;
      Pack rest;
      fetch(a + i, size - i, entries);
      fetch(high + i, size - i, sum);
      fetch(low + i, size - i, rest);
      addProduct(entries, x, y, sum, rest);
      put(sum, size - i, high + i);
      put(rest, size - i, low + i);
    }
  }
};

}  // namespace

Doubled::Doubled(const std::vector<long double>& numbers) {
  for (const long double number : numbers) {
    const Halves halves(number);
    high.push_back(halves.high);
    low.push_back(halves.low);
  }
}

std::vector<long double> Doubled::joined() const {
  std::vector<long double> result(high.begin(), high.end());
  for (std::size_t i = 0; i < low.size(); ++i)
    result[i] += low[i];
  return result;
}

long double dotDoubled(const double* a, Index size, const Doubled& x, Index first) {
  long double result = 0;
  dispatch(Dot{a, x.high.data() + first, x.low.data() + first, size, result});
  return result;
}

void addDoubled(long double factor, const double* a, Index size, Doubled& y,
                Index first) {
  dispatch(
      AddMultiple{Halves(factor), a, y.high.data() + first, y.low.data() + first, size});
}

}  // namespace epafi::bem
