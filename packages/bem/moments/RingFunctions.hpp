#pragma once

#include "bem/moments/RingJet.hpp"

namespace epafi::bem {

/// Integrals over the angle between two rings with the radii ρ (of x) and r (of y), R the distance
/// of their points, w = x - y in the plane of a meridian:            [doc/theory/axisymmetric.md]
///
///   e0 = ∫ dφ/R,  e1 = ∫ cos φ/R dφ,  es = ∫ sin² φ/R dφ  over a whole turn,
///   ∫ 1/R³ = g1 + g2,  ∫ cos φ/R³ = g1 - g2,
///   ∫ cos φ (ρ cos φ - r)/R³ = (ρ - r)(g1 - g2) - 2ρ (g2 - 2 g3).
///
/// By the complete integrals B = ∫ cos²/Δ, D = ∫ sin²/Δ, S = (D - B)/m, Δ² = 1 - m sin² over a
/// quarter of a turn, q² = |w|² + 4ρr, m = 4ρr/q², m₁ = |w|²/q²:
///
///   e0 = 4 (B + D)/q,  e1 = 4 m S/q,  es = 16 (D - S)/3q,
///   g1 = 4 B/(q |w|²),  g2 = 4 D/q³,  g3 = 4 (D - S)/q³.
///
/// Nothing cancels: on the axis m = 0, and where rings coincide only g1 is infinite, with
/// B = 1 + O(m₁ log m₁).  Number: Pack, or RingJet with the derivatives by x.
template <class Number>
struct RingFunctionsOf {
  Number e0;
  Number e1;
  Number es;
  Number g1;
  Number g2;
  Number g3;
};
using RingFunctions = RingFunctionsOf<Pack>;

/// B, D, S and T = (D - 4S)/m as p(m₁) - pLog(m₁) log m₁ on (0, 1]: least squares in 60 digits, errors
/// 2e-18, 2e-17, 3e-16 and 2e-16.
struct RingPolynomials {
  static constexpr int degree = 11;
  static constexpr double b[] = {1.0,
                                 0.05685281943936778825,
                                 0.01708442000090476271,
                                 0.008030015653410662416,
                                 0.004584884321256196022,
                                 0.001561662221901364710,
                                 -0.01322476092763466518,
                                 -0.06505663359124135470,
                                 -0.1189808167114886766,
                                 -0.08447571711650299590,
                                 -0.01997531501349674390,
                                 -0.001002394879028026947};
  static constexpr double bLog[] = {0.0,
                                    -0.2499999999999306134,
                                    -0.2812499997323905430,
                                    -0.2929686311028109367,
                                    -0.2990594147744750436,
                                    -0.3023442290202790662,
                                    -0.2985493654139466930,
                                    -0.2628869639710950127,
                                    -0.1664543805356531632,
                                    -0.05696865007399629820,
                                    -0.007529758932899235210,
                                    -0.0002067634711117253610};
  static constexpr double d[] = {
      0.3862943611198906345,   0.03972077084117561910,  0.01380072523243106113,
      0.006907730932132537560, 0.004189911856191195188, 0.004366232788742741908,
      0.01868695043574655163,  0.07276928152872673690,  0.1276837723042116612,
      0.08910233847409090750,  0.02083897892335220824,  0.001037108960756453562};
  static constexpr double dLog[] = {
      0.4999999999999999990, 0.3749999999998647893,   0.3515624996225890355,
      0.3417967262962911279, 0.3364412030193083440,   0.3325644630282261319,
      0.3233045381433486929, 0.2812151696400509473,   0.1761827438103889194,
      0.0597418529391433721, 0.007833578922731601103, 0.0002136471409356624587};
  static constexpr double s[] = {
      -0.6137056388801091068, -0.6308376874581579490, -0.6341213414379483371,
      -0.6352313307999235915, -0.6346679883918696693, -0.6069719195433079799,
      -0.3332400639560833554, 0.6846693847177436367,  1.837116248369331100,
      1.405922137325075849,   0.3402048380236852190,  0.01721290288092624023};
  static constexpr double sLog[] = {
      0.4999999999999999829, 1.124999999997625805,  1.757812493357562410,
      2.392575499649328935,  3.027839029629227698,  3.654602385553827892,
      4.165527502658095493,  4.060999701834388918,  2.726669989355684923,
      0.9605853432852464888, 0.1286560980379627223, 0.003553042355315412404};
  static constexpr int degreeOfT = 12;
  static constexpr double t[] = {
      2.8411169166403279588,  5.4041884373803743076,  7.9544746468060562732,
      10.502336157385663749,  13.046573951257942083,  15.480975802244984381,
      16.314647170803272705,  7.9833520907844666722,  -17.321019523587190794,
      -35.860610324406793652, -22.065394148397930204, -4.3890178928155316708,
      -0.18614759536968491029};
  static constexpr double tLog[] = {
      -1.4999999999999999887, -5.6249999999978338909, -12.304687491597109841,
      -21.533198491925709431, -33.308508064763544307, -47.59870766512432091,
      -63.807404666025546624, -77.248556562945839238, -73.667165834119100893,
      -44.714908333642903289, -13.659638809521485307, -1.5689254189854499669,
      -0.03730508119854785115};
};

/// B, D and S.  \param m1 |w|²/q², in (0, 1]
EPAFI_INLINE void ringIntegrals(const Pack& m1, const Pack& log, Pack& b, Pack& d,
                                Pack& s) {
  using P = RingPolynomials;
  const Pack zero{};
  b = zero + P::b[P::degree];
  d = zero + P::d[P::degree];
  s = zero + P::s[P::degree];
  Pack bLog = zero + P::bLog[P::degree];
  Pack dLog = zero + P::dLog[P::degree];
  Pack sLog = zero + P::sLog[P::degree];
#pragma GCC unroll 11
  for (int k = P::degree - 1; k >= 0; --k) {
    b = b * m1 + P::b[k];
    d = d * m1 + P::d[k];
    s = s * m1 + P::s[k];
    bLog = bLog * m1 + P::bLog[k];
    dLog = dLog * m1 + P::dLog[k];
    sLog = sLog * m1 + P::sLog[k];
  }
  b -= bLog * log;
  d -= dLog * log;
  s -= sLog * log;
}

/// T
EPAFI_INLINE void ringIntegral(const Pack& m1, const Pack& log, Pack& t) {
  using P = RingPolynomials;
  t = Pack{} + P::t[P::degreeOfT];
  Pack tLog = Pack{} + P::tLog[P::degreeOfT];
#pragma GCC unroll 12
  for (int k = P::degreeOfT - 1; k >= 0; --k) {
    t = t * m1 + P::t[k];
    tLog = tLog * m1 + P::tLog[k];
  }
  t -= tLog * log;
}

template <Division>
EPAFI_INLINE void ringIntegrals(const Pack& m1, Pack& b, Pack& d, Pack& s) {
  Pack log;
  logarithm(m1, log);
  ringIntegrals(m1, log, b, d, s);
}

/// dB/dm₁ = -S/2, dD/dm₁ = -(D - S)/2m₁, dS/dm₁ = -(T + 3S)/2m₁
template <Division How>
EPAFI_INLINE void ringIntegrals(const RingJet& m1, RingJet& b, RingJet& d, RingJet& s) {
  Pack log;
  logarithm(m1.value, log);
  ringIntegrals(m1.value, log, b.value, d.value, s.value);
  Pack t;
  ringIntegral(m1.value, log, t);
  Pack inverse;
  reciprocal<How>(m1.value, inverse);
  const Pack half = -0.5 * inverse;
  const Pack ofB = -0.5 * s.value;
  const Pack ofD = half * (d.value - s.value);
  const Pack ofS = half * (t + 3.0 * s.value);
  b = {b.value, ofB * m1.r, ofB * m1.z};
  d = {d.value, ofD * m1.r, ofD * m1.z};
  s = {s.value, ofS * m1.r, ofS * m1.z};
}

/// \param distance2 |w|² > 0  \param product 4ρr >= 0
template <Division How, class Number>
EPAFI_INLINE void ringFunctions(const Number& distance2, const Number& product,
                                RingFunctionsOf<Number>& to) {
  Number inverse2;  // 1/q²
  reciprocal<How>(distance2 + product, inverse2);
  Number b;
  Number d;
  Number s;
  ringIntegrals<How>(distance2 * inverse2, b, d, s);
  Number inverse;
  squareRoot(inverse2, inverse);
  const Number fourth = 4.0 * inverse;
  const Number cubic = fourth * inverse2;
  Number near;
  reciprocal<How>(distance2, near);
  to.e0 = fourth * (b + d);
  to.e1 = fourth * (product * inverse2) * s;
  to.es = (4.0 / 3) * fourth * (d - s);
  to.g1 = fourth * near * b;
  to.g2 = cubic * d;
  to.g3 = cubic * (d - s);
}

}  // namespace epafi::bem
