#include "contact/problem/Numbering.hpp"

namespace epafi::contact {

Numbering::Numbering(const std::vector<Count>& bodies) {
  for (const Count& count : bodies)
    normals_ += count.normals;
  Index normal = 0;
  Index tangential = normals_;
  for (const Count& count : bodies) {
    starts_.push_back({count, normal, tangential});
    normal += count.normals;
    tangential += count.size - count.normals;
  }
  size_ = tangential;
}

}  // namespace epafi::contact
