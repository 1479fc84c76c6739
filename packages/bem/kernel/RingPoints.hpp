#pragma once

#include "bem/moments/RingKernels.hpp"

namespace epafi::bem {

/// A function of x and y with its derivatives along given directions, of x, of y and of both.
struct RingDual {
  Pack value;
  Pack x;
  Pack y;
  Pack xy;
};

EPAFI_INLINE RingDual operator+(const RingDual& a, const RingDual& b) {
  return {a.value + b.value, a.x + b.x, a.y + b.y, a.xy + b.xy};
}
EPAFI_INLINE RingDual operator-(const RingDual& a, const RingDual& b) {
  return {a.value - b.value, a.x - b.x, a.y - b.y, a.xy - b.xy};
}
EPAFI_INLINE RingDual operator*(const RingDual& a, const RingDual& b) {
  return {a.value * b.value, a.value * b.x + a.x * b.value, a.value * b.y + a.y * b.value,
          a.value * b.xy + a.x * b.y + (a.y * b.x + a.xy * b.value)};
}
EPAFI_INLINE RingDual operator*(double s, const RingDual& a) {
  return {s * a.value, s * a.x, s * a.y, s * a.xy};
}

/// Kernels e1, e0, es, rr, zr, rz and zz of RingKernels with derivatives along the tangents.
struct RingSlopes {
  RingDual e1;
  RingDual e0;
  RingDual es;
  RingDual rr;
  RingDual zr;
  RingDual rz;
  RingDual zz;
};

// With f(m) of m = 4ρr/q²,
//
//   r_x r_y (E₁, E₀, E_s) = q (m² S, m (B + D), 4/3 m (D - S)),
//   r_x r_y (g₁, g₂) = (m B/m₁, m D)/q,   4ρr r_x r_y g₃ = q m² (D - S),
//
// and dB/dm = S/2, dD/dm = (D - S)/2m₁, dS/dm = (T + 3S)/2m₁, m dT/dm = (3mT - 9S - 6T)/2m₁: nothing
// is divided by m, which vanishes on the axis.
template <Division How>
// NOLINTNEXTLINE(readability-function-*): of one formula
EPAFI_INLINE void ringSlopes(const RingPair& at, RingSlopes& to) {
  const Pack zero{};
  const Pack& dr = at.w.re;
  const Pack& dz = at.w.im;
  const Pack& txr = at.tangentX.re;
  const Pack& txz = at.tangentX.im;
  const Pack& tyr = at.tangentY.re;
  const Pack& tyz = at.tangentY.im;
  const RingDual a{dr * dr + dz * dz, 2.0 * (dr * txr + dz * txz),
                   -2.0 * (dr * tyr + dz * tyz), -2.0 * (txr * tyr + txz * tyz)};
  const RingDual b{4.0 * at.x * at.y, 4.0 * at.y * txr, 4.0 * at.x * tyr,
                   4.0 * txr * tyr};
  const RingDual square = a + b;
  Pack u;  // 1/q²
  reciprocal<How>(square.value, u);
  Pack o;  // 1/m₁
  reciprocal<How>(a.value, o);
  o *= square.value;
  const Pack m = b.value * u;
  const Pack m1 = a.value * u;
  // of m₁ = a/(a + b), without a difference where one of them is small
  const Pack m1x = u * (m * a.x - m1 * b.x);
  const Pack m1y = u * (m * a.y - m1 * b.y);
  const Pack m1xy =
      u * (m * a.xy - m1 * b.xy + u * (b.y * a.x - a.y * b.x) - 2.0 * m1x * square.y);
  const Pack mxy2 = m1x * m1y;
  Pack log;
  logarithm(m1, log);
  Pack cosine;  // B
  Pack sine;    // D
  Pack s;
  ringIntegrals(m1, log, cosine, sine, s);
  Pack t;
  ringIntegral(m1, log, t);

  // derivatives by m
  const Pack halfO = 0.5 * o;
  const Pack difference = sine - s;
  const Pack threeS = 3.0 * s;
  const Pack s1 = halfO * (t + threeS);
  const Pack d1 = halfO * (difference - t - threeS);
  const Pack mt1 = halfO * (3.0 * m * t - 3.0 * threeS - 6.0 * t);
  const Pack ms2 = halfO * (mt1 + 3.0 * m * s1) + m * (o * s1);
  const Pack md2 = halfO * (m * d1 - mt1 - 3.0 * m * s1) + m * (o * d1);
  const Pack sineSlope = halfO * difference;
  const Pack sineBend = halfO * d1 + o * sineSlope;
  const auto of = [&](const Pack& f, const Pack& f1, const Pack& f2) {
    return RingDual{f, -f1 * m1x, -f1 * m1y, f2 * mxy2 - f1 * m1xy};
  };
  const Pack md = m * difference;
  const Pack md1 = difference + m * d1;
  const Pack mdd2 = 2.0 * d1 + md2;

  Pack root;
  squareRoot(u, root);
  const Pack ofInverse = -0.5 * root * u;
  const RingDual inverse{root, ofInverse * square.x, ofInverse * square.y,
                         ofInverse * (square.xy - 1.5 * u * square.x * square.y)};
  const RingDual q = square * inverse;
  to.e1 = q * of(m * m * s, m * (2.0 * s + m * s1), 2.0 * s + 4.0 * m * s1 + m * ms2);
  const Pack sum = 0.5 * s + sineSlope;
  to.e0 = q * of(m * (cosine + sine), cosine + sine + m * sum,
                 2.0 * sum + m * (0.5 * s1 + sineBend));
  const RingDual turned = q * of(md, md1, mdd2);
  to.es = (4.0 / 3) * turned;
  const RingDual third = q * of(m * md, md + m * md1, 2.0 * md1 + m * mdd2);
  const Pack oo = o * o;
  const RingDual g1 = inverse * of(m * o * cosine, oo * cosine + 0.5 * m * o * s,
                                   oo * (2.0 * o * cosine + s) + 0.5 * m * o * s1);
  const RingDual g2 =
      inverse * of(m * sine, sine + m * sineSlope, 2.0 * sineSlope + m * sineBend);
  const RingDual sums = g1 + g2;
  const RingDual wr{dr, txr, -tyr, zero};
  const RingDual wz{dz, txz, -tyz, zero};
  const RingDual along = wr * sums;
  to.rr = wr * (wr * (g1 - g2)) - third;
  to.zz = wz * (wz * sums);
  to.rz = wz * (along + 2.0 * (RingDual{at.y, zero, tyr, zero} * g2));
  to.zr = wz * (along - 2.0 * (RingDual{at.x, txr, zero, zero} * g2));
}

/// Kernels of solids of revolution at pairs of points, see FarQuadrature: of whole revolutions, those of
/// RingKernels with derivatives of functions taken off them by parts.
///                                                            [doc/theory/axisymmetric.md]
struct RingPoints {
  static constexpr int components = 2;
  using Constants = RingLame;

  Pack v[4];  ///< -V: rr, zr, rz, zz
  Pack k[4];
  Pack t[4];  ///< K'
  Pack w[4];
  // of a jump of u where elements end: what K and W by parts have more
  Pack jumpK[4];
  Pack jumpW[4];

  template <Division How>
  // NOLINTNEXTLINE(readability-function-*): of one formula
  EPAFI_INLINE void evaluate(const RingLame& lame, const Pack& dr, const Pack& dz,
                             const Pack& tr, const Pack& tz, const Pack& radius,
                             const double* source) {
    const Pack zero{};
    const RingPair at{radius,
                      zero + source[4],
                      {dr, dz},
                      {tr, tz},
                      {zero + source[2], zero + source[3]}};
    RingKernels plain;  // NOLINT(cppcoreguidelines-pro-type-member-init)
    ringKernels<How>(lame, at, plain);
    RingSlopes of;  // NOLINT(cppcoreguidelines-pro-type-member-init)
    ringSlopes<How>(at, of);
    const auto value = [&](int kernel) -> const Pack& { return plain.of[kernel]; };
    using K = RingKernels;
    constexpr double turn = 6.2831853071795865;
    v[0] = -turn * (lame.a * value(K::e1) + lame.b * value(K::rr));
    v[1] = -turn * lame.b * value(K::zr);
    v[2] = -turn * lame.b * value(K::rz);
    v[3] = -turn * (lame.a * value(K::e0) + lame.b * value(K::zz));
    const RingDual radial = lame.part * of.e1 + of.rr;
    const RingDual axial = lame.part * of.e0 + of.zz;
    const double doubled = turn * lame.doubled;
    jumpK[0] = doubled * of.rz.value;
    jumpK[1] = doubled * axial.value;
    jumpK[2] = -doubled * radial.value;
    jumpK[3] = -doubled * of.zr.value;
    k[0] = turn * value(K::ofY) - doubled * of.rz.y;
    k[1] = turn * value(K::ofY + 1) - doubled * axial.y;
    k[2] = doubled * radial.y;
    k[3] = turn * value(K::ofY + 2) + doubled * of.zr.y;
    t[0] = turn * value(K::ofX) - doubled * of.zr.x;
    t[1] = doubled * radial.x;
    t[2] = turn * value(K::ofX + 1) - doubled * axial.x;
    t[3] = turn * value(K::ofX + 2) + doubled * of.rz.x;
    const double curl = turn * lame.curl;
    const double squared = turn * lame.squared;
    const RingDual slopesR = curl * (of.e0 - of.es) - squared * axial;
    const RingDual slopesZ = curl * of.e1 - squared * radial;
    Pack overX;
    reciprocal<How>(radius, overX);
    const double overY = 1 / source[4];
    const Pack& tyr = at.tangentY.re;
    const Pack& tyz = at.tangentY.im;
    jumpW[0] = turn * value(K::xSlope) - slopesR.x;
    jumpW[1] = -squared * of.rz.x;
    jumpW[2] = turn * value(K::xSlope + 1) - squared * of.zr.x;
    jumpW[3] = -slopesZ.x;
    // with derivatives of xSlope by y, of ySlope by x
    w[0] = slopesR.xy + turn * value(K::both) -
           overX * (squared * (tz * of.rz.y - tr * axial.y) + curl * tr * of.es.y) -
           overY * (squared * (tyz * of.zr.x - tyr * axial.x) + curl * tyr * of.es.x);
    w[1] = squared * (of.rz.xy + overY * (tyz * radial.x - tyr * of.rz.x));
    w[2] = squared * (of.zr.xy + overX * (tz * radial.y - tr * of.zr.y));
    w[3] = slopesZ.xy;
  }
};

}  // namespace epafi::bem
