#include "drivers/study/ReferenceFile.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/Csv.hpp"
#include "drivers/output/History.hpp"
#include "drivers/scene/SceneFile.hpp"

#include <sstream>

namespace epafi::drivers {

namespace {

const char* const format = "epafi reference 1";

using Series = std::array<bem::Complex, bem::largestDegree + 1>;

/// What decides on the solution: everything but what is written and who computed it.
std::string problemOf(const Scene& scene) {
  Teuchos::ParameterList list(*scene.used);
  list.remove("Versions", false);
  list.remove("Output", false);
  return toXml(list, "");
}

void write(std::ostream& out, const Series& series, int terms) {
  for (int i = 0; i < terms; ++i) {
    const bem::Complex value = series[static_cast<std::size_t>(i)];
    out << ' ' << exactly(value.real()) << ' ' << exactly(value.imag());
  }
}

bool read(std::istream& in, Series& series, int terms) {
  series.fill(0);
  for (int i = 0; i < terms; ++i) {
    double real = 0;
    double imaginary = 0;
    if (!(in >> real >> imaginary))
      return false;
    series[static_cast<std::size_t>(i)] = {real, imaginary};
  }
  return true;
}

void writeElement(std::ostream& out, const Snapshot& snapshot, int e) {
  const auto k = static_cast<std::size_t>(e);
  const bem::Piece& piece = snapshot.data.mesh[e].piece;
  const int p = piece.degree;
  out << piece.edge << ' ' << p << ' ' << (snapshot.contact[k] ? 1 : 0);
  for (const bem::Position& end : {piece.start, piece.end})
    out << ' ' << exactly(end.fromStart) << ' ' << exactly(end.toEnd);
  write(out, snapshot.data.fields[k].value, p + 1);
  write(out, snapshot.data.fields[k].slope, p);
  write(out, snapshot.data.fields[k].density, p);
  write(out, snapshot.multiplier[k], p + 1);
  out << '\n';
}

/// What a file says of all elements, before there is a mesh.
struct Elements {
  std::vector<bem::Piece> pieces;
  std::vector<bem::LocalField> fields;
  std::vector<Series> multiplier;
  std::vector<bool> contact;
};

bool readElement(std::istream& in, Elements& all) {
  bem::Piece piece;
  int contact = 0;
  in >> piece.edge >> piece.degree >> contact;
  for (bem::Position* end : {&piece.start, &piece.end})
    in >> end->fromStart >> end->toEnd;
  const int p = piece.degree;
  bem::LocalField field;
  Series multiplier;
  if (!in || p < 1 || p > bem::largestDegree || !read(in, field.value, p + 1) ||
      !read(in, field.slope, p) || !read(in, field.density, p) ||
      !read(in, multiplier, p + 1))
    return false;
  all.pieces.push_back(piece);
  all.fields.push_back(field);
  all.multiplier.push_back(multiplier);
  all.contact.push_back(contact != 0);
  return true;
}

}  // namespace

std::string referenceText(const Reference& reference, const Scene& scene) {
  std::ostringstream out;
  out << format << '\n' << problemOf(scene) << "solution\n";
  for (const std::string& cell : reference.cells)
    out << cell << '\n';
  out << exactly(reference.estimate) << ' ' << exactly(reference.solution.energy) << ' '
      << reference.solution.data.mesh.size() << '\n';
  for (int e = 0; e < reference.solution.data.mesh.size(); ++e)
    writeElement(out, reference.solution, e);
  return out.str();
}

std::optional<Reference> parseReference(const std::string& text, const Scene& scene) {
  const std::string head = std::string(format) + "\n" + problemOf(scene) + "solution\n";
  if (text.compare(0, head.size(), head) != 0)
    return std::nullopt;
  std::istringstream in(text.substr(head.size()));
  std::vector<std::string> cells(historyColumns().size());
  for (std::string& cell : cells)
    std::getline(in, cell);
  double estimate = 0;
  double energy = 0;
  int count = 0;
  in >> estimate >> energy >> count;
  Elements all;
  for (int e = 0; e < count; ++e)
    if (!readElement(in, all))
      return std::nullopt;
  if (count < 1)
    return std::nullopt;
  try {
    return Reference{Snapshot{{bem::Mesh(scene.outline, all.pieces), all.fields},
                              all.multiplier,
                              all.contact,
                              energy},
                     estimate, cells};
  } catch (const bem::InputError&) {
    return std::nullopt;  // no mesh of this outline
  }
}

}  // namespace epafi::drivers
