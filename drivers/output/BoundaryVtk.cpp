#include "drivers/output/BoundaryVtk.hpp"

#include "drivers/output/Csv.hpp"
#include "drivers/output/Hdf5File.hpp"

#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <utility>

namespace epafi::drivers {

namespace {

/// Appends the bytes as Base64 (RFC 4648).
void addBase64(std::string bytes, std::string& text) {
  constexpr char letters[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  bytes.resize(bytes.size() + missing);
  std::size_t place = text.size();
  text.resize(place + bytes.size() / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | static_cast<unsigned char>(bytes[i + k]);
    for (std::size_t k = 0; k < 4; ++k)
      text[place++] = letters[group >> (18 - 6 * k) & 63U];
  }
  text.replace(place - missing, missing, missing, '=');
}

template <class T>
constexpr const char* typeName() {
  if (std::is_same_v<T, double>)
    return "Float64";
  return sizeof(T) == 8 ? "Int64" : sizeof(T) == 4 ? "Int32" : "UInt8";
}

constexpr unsigned char vtkLine = 3;

/// Calls visit(name, array, columns) for each field at the points.
template <class Visit>
void forPointData(const BoundaryLines& grid, const Visit& visit) {
  visit("displacement", grid.displacement, 3);
  visit("traction", grid.traction, 3);
  visit("lambda_n", grid.pressure, 1);
  visit("lambda_t", grid.shear, 1);
  visit("gap", grid.gap, 1);
  visit("contact", grid.contact, 1);
  visit("friction", grid.friction, 1);
}

/// The same for the fields of the segments.
template <class Visit>
void forCellData(const BoundaryLines& grid, const Visit& visit) {
  visit("element", grid.element, 1);
  visit("degree", grid.degree, 1);
  visit("boundary", grid.boundary, 1);
  visit("body", grid.body, 1);
}

/// VTK offsets of segments first ... last: each has two points.
std::vector<long long> offsetsOf(std::size_t first, std::size_t last) {
  std::vector<long long> offsets;
  for (std::size_t line = first; line <= last; ++line)
    offsets.push_back(static_cast<long long>(2 * line));
  return offsets;
}

const std::string format =
    "version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n";

}  // namespace

// The data begin with their number of bytes.
template <class T>
std::string dataArray(const char* name, const std::vector<T>& values, int components) {
  const std::uint64_t size = values.size() * sizeof(T);
  std::string bytes(sizeof size + size, '\0');
  std::memcpy(bytes.data(), &size, sizeof size);
  std::memcpy(bytes.data() + sizeof size, values.data(), size);
  std::string text = std::string("<DataArray type=\"") + typeName<T>() + "\" Name=\"" +
                     name + R"(" NumberOfComponents=")" + std::to_string(components) +
                     R"(" format="binary">)";
  text.reserve(text.size() + 4 * bytes.size() / 3 + 20);
  addBase64(std::move(bytes), text);
  text += "</DataArray>\n";
  return text;
}

template std::string dataArray(const char*, const std::vector<double>&, int);
template std::string dataArray(const char*, const std::vector<int>&, int);
template std::string dataArray(const char*, const std::vector<long long>&, int);
template std::string dataArray(const char*, const std::vector<unsigned char>&, int);

std::string vtuText(const VtuGrid& grid) {
  const std::string head =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" " + format +
      "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" + std::to_string(grid.points) +
      "\" NumberOfCells=\"" + std::to_string(grid.cells) + "\">\n<PointData " +
      grid.shown + ">\n";
  std::vector<std::string_view> parts{head};
  const auto add = [&](const std::vector<std::string>& arrays, std::string_view end) {
    parts.insert(parts.end(), arrays.begin(), arrays.end());
    parts.push_back(end);
  };
  add(grid.pointData, "</PointData>\n<CellData>\n");
  add(grid.cellData, "</CellData>\n<Points>\n");
  add(grid.places, "</Points>\n<Cells>\n");
  add(grid.topology, "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  // reserve once: appending long texts would copy them again and again
  std::size_t size = 0;
  for (const std::string_view part : parts)
    size += part.size();
  std::string text;
  text.reserve(size);
  for (const std::string_view part : parts)
    text += part;
  return text;
}

std::string boundaryVtu(const BoundaryLines& grid) {
  const std::size_t lines = grid.element.size();
  VtuGrid vtu{grid.pressure.size(), lines, "Vectors=\"displacement\""};
  forPointData(grid, [&](const char* name, const auto& array, int columns) {
    vtu.pointData.push_back(dataArray(name, array, columns));
  });
  forCellData(grid, [&](const char* name, const auto& array, int columns) {
    vtu.cellData.push_back(dataArray(name, array, columns));
  });
  vtu.places = {dataArray("Points", grid.points, 3)};
  vtu.topology = {dataArray("connectivity", grid.ends),
                  dataArray("offsets", offsetsOf(1, lines)),
                  dataArray("types", std::vector<unsigned char>(lines, vtkLine))};
  return vtuText(vtu);
}

std::string stepsPvd(const std::vector<double>& times, const std::string& name) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" " + format +
                     "<Collection>\n";
  for (std::size_t k = 0; k < times.size(); ++k)
    text += "<DataSet timestep=\"" + exactly(times[k]) + R"(" part="0" file=")" +
            stepFile(k + 1, name) + "\"/>\n";
  return text + "</Collection>\n</VTKFile>\n";
}

std::string stepFile(std::size_t step, const std::string& name) {
  return "steps/" + std::to_string(step) + "/" + name;
}

void writeVtkHdf(const BoundaryLines& grid, Hdf5Writer& writer) {
  writer.attribute("/VTKHDF", "Version", std::vector<int>{1, 0});
  writer.attribute("/VTKHDF", "Type", "UnstructuredGrid");
  const auto write = [&](const std::string& name, const auto& array, int columns = 1) {
    writer.array("/VTKHDF/" + name, array, columns);
  };
  const auto count = [](const auto& array) {
    return std::vector<long long>{static_cast<long long>(array.size())};
  };
  const std::size_t lines = grid.element.size();
  write("NumberOfPoints", count(grid.pressure));
  write("NumberOfCells", count(grid.element));
  write("NumberOfConnectivityIds", count(grid.ends));
  write("Points", grid.points, 3);
  write("Connectivity", grid.ends);
  write("Offsets", offsetsOf(0, lines));
  write("Types", std::vector<unsigned char>(lines, vtkLine));
  forPointData(grid, [&](const char* name, const auto& array, int columns) {
    write(std::string("PointData/") + name, array, columns);
  });
  forCellData(grid, [&](const char* name, const auto& array, int columns) {
    write(std::string("CellData/") + name, array, columns);
  });
}

}  // namespace epafi::drivers
