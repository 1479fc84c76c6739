#include "drivers/output/ContactTable.hpp"

#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/Csv.hpp"

namespace epafi::drivers {

namespace {

/// Arc length along a contact boundary.  It starts at 0 on each chain of consecutive
/// elements of one contact.
class ArcLength {
 public:
  ArcLength(const bem::Mesh& mesh, double length) : mesh_(mesh), length_(length) {}

  /// Elements must come in the order of the multiplier; t in [-1, 1].  Returns a length.
  double at(const contact::MultiplierSpace::ContactElement& element, double t) {
    if (&element != last_) {
      const bool follows = last_ != nullptr &&
                           mesh_[last_->element].next == element.element &&
                           last_->condition == element.condition;
      start_ = follows ? start_ + 2 * mesh_[last_->element].half : 0;
      last_ = &element;
    }
    return length_ * (start_ + mesh_[element.element].half * (1 + t));
  }

 private:
  const bem::Mesh& mesh_;
  double length_;
  const contact::MultiplierSpace::ContactElement* last_ = nullptr;
  double start_ = 0;
};

}  // namespace

std::string contactCsv(const Scene& scene, const std::vector<contact::Solved>& bodies,
                       const MoreContactColumns& more) {
  std::vector<std::string> names = {"boundary", "element",      "x",       "y",
                                    "lambda_n", "lambda_t",     "u_n",     "u_t",
                                    "gap",      "bound",        "contact", "friction",
                                    "body",     "contact_name", "s"};
  names.insert(names.end(), more.names.begin(), more.names.end());
  names.insert(names.end(), {"normal_closing", "pressure", "shear"});
  std::string csv = csvLine(names);
  const int samples = scene.output.contactSamples;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const contact::ContactFields fields(bodies[b]);
    const bem::Vector continuous = fields.continuous();
    ArcLength arc(bodies[b].space.mesh(), bodies[b].units.length);
    for (const auto& element : fields.elements())
      for (int k = 0; k < samples; ++k) {
        const double t = -1 + (2.0 * k + 1) / samples;
        const contact::ContactPoint p = fields.at(element, t);
        const std::string& name = element.condition->name;
        std::vector<std::string> cells = {scene.boundaryName(b, *element.boundary),
                                          std::to_string(element.element),
                                          exactly(p.place.x),
                                          exactly(p.place.y),
                                          exactly(p.pressure),
                                          exactly(p.shear),
                                          exactly(p.normal),
                                          exactly(p.tangential),
                                          exactly(p.gap),
                                          exactly(p.bound),
                                          p.closed ? "1" : "0",
                                          std::to_string(numberOf(p.friction)),
                                          scene.bodies[b].name,
                                          name.empty() ? *element.boundary : name,
                                          exactly(arc.at(element, t))};
        if (more.cells)
          for (std::string& cell : more.cells(b, element, t, p))
            cells.push_back(std::move(cell));
        const auto stress = fields.inUnits(continuous, element, t);
        cells.insert(cells.end(), {exactly(p.closing), exactly(stress.normal),
                                   exactly(stress.tangential)});
        csv += csvLine(cells);
      }
  }
  return csv;
}

}  // namespace epafi::drivers
