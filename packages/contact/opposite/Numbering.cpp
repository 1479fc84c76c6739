#include "contact/opposite/Numbering.hpp"

namespace epafi::contact {

Numbering::Numbering(const std::vector<ContactSide>& bodies) {
  for (const ContactSide& body : bodies)
    normals_ += body.multiplier.normals();
  Index normal = 0;
  Index tangential = normals_;
  for (const ContactSide& body : bodies) {
    const Index normals = body.multiplier.normals();
    const Index size = body.multiplier.size();
    starts_.push_back({normals, size, normal, tangential});
    normal += normals;
    tangential += size - normals;
  }
  size_ = tangential;
}

}  // namespace epafi::contact
