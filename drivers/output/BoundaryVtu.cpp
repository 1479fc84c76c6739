#include "drivers/output/BoundaryVtu.hpp"

#include "drivers/output/Csv.hpp"

#include <cstdint>
#include <cstring>

namespace epafi::drivers {

namespace {

/// RFC 4648.
std::string base64(const std::string& bytes) {
  constexpr char letters[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * bytes.size() / 3 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 |
              (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : letters[group >> (18 - 6 * k) & 63U];
  }
  return text;
}

template <class T>
const char* typeName();
template <>
const char* typeName<double>() {
  return "Float64";
}
template <>
const char* typeName<int>() {
  return "Int32";
}
template <>
const char* typeName<long long>() {
  return "Int64";
}
template <>
const char* typeName<unsigned char>() {
  return "UInt8";
}

/// The number of bytes goes before them.
template <class T>
std::string dataArray(const char* name, const std::vector<T>& values,
                      int components = 1) {
  const std::uint64_t size = values.size() * sizeof(T);
  std::string bytes(sizeof size + size, '\0');
  std::memcpy(bytes.data(), &size, sizeof size);
  std::memcpy(bytes.data() + sizeof size, values.data(), size);
  return std::string("<DataArray type=\"") + typeName<T>() + "\" Name=\"" + name +
         "\" NumberOfComponents=\"" + std::to_string(components) +
         "\" format=\"binary\">" + base64(bytes) + "</DataArray>\n";
}

const std::string head =
    "version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n";

}  // namespace

std::string boundaryVtu(const BoundaryLines& grid) {
  constexpr unsigned char vtkLine = 3;
  const std::size_t lines = grid.element.size();
  std::vector<long long> offsets;
  for (std::size_t line = 1; line <= lines; ++line)
    offsets.push_back(static_cast<long long>(2 * line));
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" " + head +
         "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
         std::to_string(grid.pressure.size()) + "\" NumberOfCells=\"" +
         std::to_string(lines) + "\">\n<PointData Vectors=\"displacement\">\n" +
         dataArray("displacement", grid.displacement, 3) +
         dataArray("traction", grid.traction, 3) + dataArray("lambda_n", grid.pressure) +
         dataArray("lambda_t", grid.shear) + dataArray("gap", grid.gap) +
         dataArray("contact", grid.contact) + dataArray("friction", grid.friction) +
         "</PointData>\n<CellData>\n" + dataArray("element", grid.element) +
         dataArray("degree", grid.degree) + dataArray("boundary", grid.boundary) +
         dataArray("body", grid.body) + "</CellData>\n<Points>\n" +
         dataArray("Points", grid.points, 3) + "</Points>\n<Cells>\n" +
         dataArray("connectivity", grid.ends) + dataArray("offsets", offsets) +
         dataArray("types", std::vector<unsigned char>(lines, vtkLine)) +
         "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string stepsPvd(const std::vector<double>& times) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" " + head + "<Collection>\n";
  for (std::size_t k = 0; k < times.size(); ++k)
    text += "<DataSet timestep=\"" + exactly(times[k]) + "\" part=\"0\" file=\"" +
            stepFile(k + 1, "boundary.vtu") + "\"/>\n";
  return text + "</Collection>\n</VTKFile>\n";
}

std::string stepFile(std::size_t step, const std::string& name) {
  return "steps/" + std::to_string(step) + "/" + name;
}

}  // namespace epafi::drivers
