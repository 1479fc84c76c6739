#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::contact {

using bem::Index;
using bem::Vector;

/// The numbers that the coefficients of a body's multiplier have in the problem of all
/// bodies: normal ones first.
class Numbering {
 public:
  /// Sizes of MultiplierSpaces.
  struct Count {
    Index normals = 0;
    Index size = 0;
  };
  explicit Numbering(const std::vector<Count>& bodies);

  Index size() const { return size_; }
  Index normals() const { return normals_; }
  Index operator()(std::size_t b, Index own) const {
    const Start& start = starts_[b];
    return own < start.count.normals ? start.normal + own
                                     : start.tangential + own - start.count.normals;
  }
  /// How many coefficients a body has.
  Index sizeOf(std::size_t b) const { return starts_[b].count.size; }
  Index normalsOf(std::size_t b) const { return starts_[b].count.normals; }
  /// A body's own of one number per tangential coefficient of all.
  Vector tangentialsOf(std::size_t b, const Vector& all) const {
    const auto first =
        all.begin() + static_cast<std::ptrdiff_t>(starts_[b].tangential - normals_);
    return {first, first + static_cast<std::ptrdiff_t>(sizeOf(b) - normalsOf(b))};
  }

 private:
  struct Start {
    Count count;
    Index normal = 0;
    Index tangential = 0;
  };
  std::vector<Start> starts_;
  Index normals_ = 0;
  Index size_ = 0;
};

}  // namespace epafi::contact
