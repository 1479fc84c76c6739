#include "adaptivity/estimate/EndValues.hpp"

namespace epafi::adaptivity {

bem::Vec2 valueAt(const AtEnds& factors, const bem::Element& element, double t) {
  const bem::EndValues e = bem::endValues(element.degree, t);
  return (e.start / element.half) * factors.start + (e.end / element.half) * factors.end;
}

}  // namespace epafi::adaptivity
