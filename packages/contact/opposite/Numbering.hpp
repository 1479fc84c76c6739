#pragma once

#include "contact/opposite/Opposite.hpp"

namespace epafi::contact {

/// Numbering of the multipliers of all bodies in one problem: the pressures of all
/// bodies, then all other coefficients, each by bodies.
class Numbering {
 public:
  explicit Numbering(const std::vector<ContactSide>& bodies) {
    for (const ContactSide& body : bodies)
      normals_ += body.multiplier.normals();
    Index normal = 0;
    size_ = normals_;
    for (const auto& [space, multiplier, opposite] : bodies) {
      starts_.push_back({multiplier.normals(), multiplier.size(), normal, size_});
      normal += multiplier.normals();
      size_ += multiplier.size() - multiplier.normals();
    }
  }

  Index size() const { return size_; }
  Index normals() const { return normals_; }
  /// Number of coefficient `own` of body b.
  Index operator()(std::size_t b, Index own) const {
    const Start& start = starts_[b];
    return own < start.normals ? start.normal + own
                               : start.tangential + own - start.normals;
  }
  /// Number of coefficients of a body; of its pressures.
  Index sizeOf(std::size_t b) const { return starts_[b].size; }
  Index normalsOf(std::size_t b) const { return starts_[b].normals; }
  /// The coefficients of body b, as it numbers them.
  Vector of(std::size_t b, const Vector& all) const {
    Vector own(at(sizeOf(b)));
    for (Index i = 0; i < sizeOf(b); ++i)
      own[at(i)] = all[at((*this)(b, i))];
    return own;
  }
  /// The part of body b in a vector with one entry per tangential coefficient of all
  /// bodies.
  Vector tangentialsOf(std::size_t b, const Vector& all) const {
    const auto first =
        all.begin() + static_cast<std::ptrdiff_t>(starts_[b].tangential - normals_);
    return {first, first + static_cast<std::ptrdiff_t>(sizeOf(b) - normalsOf(b))};
  }

 private:
  struct Start {
    Index normals = 0;
    Index size = 0;
    Index normal = 0;
    Index tangential = 0;
  };
  std::vector<Start> starts_;
  Index normals_ = 0;
  Index size_ = 0;
};

}  // namespace epafi::contact
