#include "drivers/output/Hdf5Writer.hpp"

#include "drivers/output/Hdf5Handle.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <functional>
#include <mpi.h>
#include <unistd.h>

namespace epafi::drivers {

struct Hdf5Writer::Parts {
  std::string path;
  const bem::DenseAlgebra& algebra;
  bool together = false;
  std::vector<std::function<void()>> steps;  ///< what is to be written
  long long bytes = 0;                       ///< upper bound of all that
  std::string failure;                       ///< the first one
  QuietHdf5 quiet;
  Hdf5Handle file;

  /// Notes a failure; tells whether there is none so far.
  bool good(bool fine) {
    if (!fine && failure.empty())
      failure = hdf5Cause();
    return failure.empty();
  }

  Hdf5Handle handle(hid_t id, Hdf5Handle::Close close) {
    good(id >= 0);
    return {id, close};
  }

  /// Groups on the way to `name` are made.
  Hdf5Handle linkProperties() {
    Hdf5Handle list = handle(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    good(H5Pset_create_intermediate_group(list.id(), 1) >= 0);
    return list;
  }

  Hdf5Handle group(const std::string& name) {
    if (H5Lexists(file.id(), name.c_str(), H5P_DEFAULT) > 0)
      return handle(H5Gopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Gclose);
    const Hdf5Handle links = linkProperties();
    return handle(
        H5Gcreate2(file.id(), name.c_str(), links.id(), H5P_DEFAULT, H5P_DEFAULT),
        H5Gclose);
  }

  Hdf5Handle dataset(const std::string& name, hid_t type, hid_t space) {
    const Hdf5Handle links = linkProperties();
    // Without times the same run writes the same bytes.
    const Hdf5Handle creation = handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    good(H5Pset_obj_track_times(creation.id(), false) >= 0);
    return handle(H5Dcreate2(file.id(), name.c_str(), type, space, links.id(),
                             creation.id(), H5P_DEFAULT),
                  H5Dclose);
  }

  /// Each process writes what it has selected of the file's space.
  void write(const Hdf5Handle& dataset, hid_t type, const Hdf5Handle& memory,
             const Hdf5Handle& space, const void* data) {
    const Hdf5Handle transfer = handle(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
    if (together)
      good(H5Pset_dxpl_mpio(transfer.id(), H5FD_MPIO_COLLECTIVE) >= 0);
    good(H5Dwrite(dataset.id(), type, memory.id(), space.id(), transfer.id(), data) >= 0);
  }

  Hdf5Handle stringType(std::size_t length) {
    Hdf5Handle type = handle(H5Tcopy(H5T_C_S1), H5Tclose);
    good(H5Tset_size(type.id(), std::max<std::size_t>(length, 1)) >= 0);
    good(H5Tset_strpad(type.id(), H5T_STR_NULLPAD) >= 0);
    return type;
  }

  void attribute(const std::string& group, const std::string& name, hid_t type,
                 const Hdf5Handle& space, const void* value) {
    const Hdf5Handle owner = this->group(group);
    const Hdf5Handle attribute = handle(
        H5Acreate2(owner.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose);
    good(H5Awrite(attribute.id(), type, value) >= 0);
  }

  /// To be done later; needs so much room on the disk, and some for HDF5's own.
  void later(long long room, std::function<void()> step) {
    constexpr long long own = 1024;
    bytes += room + own;
    steps.push_back(std::move(step));
  }

  template <class T>
  void writeSlice(const std::string& name, const Slice<T>& slice);
  void writeText(const std::string& name, const std::string& value);
  void reserve() const;
  void writeSteps();
  void writeTogether();
  void writeAlone();
};

template <class T>
void Hdf5Writer::Parts::writeSlice(const std::string& name, const Slice<T>& slice) {
  const std::array<hsize_t, 2> size = {static_cast<hsize_t>(slice.rows),
                                       static_cast<hsize_t>(slice.columns)};
  const std::array<hsize_t, 2> first = {static_cast<hsize_t>(slice.first), 0};
  const std::array<hsize_t, 2> count = {static_cast<hsize_t>(slice.mine.size()) / size[1],
                                        size[1]};
  const int rank = slice.columns == 1 ? 1 : 2;
  const Hdf5Handle space = handle(H5Screate_simple(rank, size.data(), nullptr), H5Sclose);
  const Hdf5Handle memory =
      handle(H5Screate_simple(rank, count.data(), nullptr), H5Sclose);
  const Hdf5Handle data = dataset(name, hdf5Type<T>(), space.id());
  if (size[0] == 0)  // has no place in the file: MPI-IO would fail
    return;
  if (count[0] == 0) {
    good(H5Sselect_none(space.id()) >= 0);
    good(H5Sselect_none(memory.id()) >= 0);
  } else {
    good(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, first.data(), nullptr,
                             count.data(), nullptr) >= 0);
  }
  const T none{};  // HDF5 wants an address
  write(data, hdf5Type<T>(), memory, space,
        slice.mine.empty() ? &none : slice.mine.data());
}

void Hdf5Writer::Parts::writeText(const std::string& name, const std::string& value) {
  const Hdf5Handle type = stringType(value.size());
  const Hdf5Handle space = handle(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle memory = handle(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle data = dataset(name, type.id(), space.id());
  if (algebra.rank() != 0) {
    good(H5Sselect_none(space.id()) >= 0);
    good(H5Sselect_none(memory.id()) >= 0);
  }
  write(data, type.id(), memory, space, value.c_str());
}

/// Is there room on the disk?  The first process asks, all know the answer.
void Hdf5Writer::Parts::reserve() const {
  int error = 0;
  if (algebra.rank() == 0) {
    const int reserved =
        open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0666);
    error = reserved < 0 ? errno : posix_fallocate(reserved, 0, bytes);
    if (reserved >= 0)
      ::close(reserved);
  }
  const bem::Vector agreed = algebra.broadcast({static_cast<double>(error)});
  if (agreed.front() != 0)
    throw bem::InputError(std::strerror(static_cast<int>(agreed.front())));
}

void Hdf5Writer::Parts::writeSteps() {
  const Hdf5Handle access = handle(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t growth = 1 << 20;
  good((together ? H5Pset_fapl_mpio(access.id(), MPI_COMM_WORLD, MPI_INFO_NULL)
                 : H5Pset_fapl_core(access.id(), growth, false)) >= 0);
  file =
      handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose);
  for (const auto& step : steps)
    step();
  good(H5Fflush(file.id(), H5F_SCOPE_GLOBAL) >= 0);
}

void Hdf5Writer::Parts::writeTogether() {
  reserve();
  writeSteps();
  good(file.close() >= 0);
  const bem::Vector failed = algebra.sum({failure.empty() ? 0.0 : 1.0});
  if (failed.front() > 0)
    throw bem::InputError(failure.empty() ? "another process cannot write" : failure);
}

void Hdf5Writer::Parts::writeAlone() {
  writeSteps();
  const ssize_t size = H5Fget_file_image(file.id(), nullptr, 0);
  std::string image(good(size > 0) ? static_cast<std::size_t>(size) : 0, '\0');
  if (!image.empty())
    good(H5Fget_file_image(file.id(), image.data(), image.size()) == size);
  good(file.close() >= 0);
  if (!failure.empty())
    throw bem::InputError(failure);

  errno = 0;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream << image;
  stream.close();
  if (!stream)
    throw bem::InputError(std::strerror(errno));
}

Hdf5Writer::Hdf5Writer(std::string path, const bem::DenseAlgebra& algebra)
    : parts_(new Parts{
          std::move(path), algebra, algebra.processes() > 1, {}, 0, {}, {}, {}}) {}

Hdf5Writer::~Hdf5Writer() = default;

template <class T>
void Hdf5Writer::array(const std::string& name, Slice<T> slice) {
  const long long room = slice.rows * slice.columns * static_cast<long long>(sizeof(T));
  parts_->later(room, [p = parts_.get(), name, slice = std::move(slice)] {
    p->writeSlice(name, slice);
  });
}

void Hdf5Writer::text(const std::string& name, const std::string& value) {
  parts_->later(static_cast<long long>(value.size()),
                [p = parts_.get(), name, value] { p->writeText(name, value); });
}

template <class T>
void Hdf5Writer::attribute(const std::string& group, const std::string& name,
                           std::vector<T> values) {
  parts_->later(0, [p = parts_.get(), group, name, values = std::move(values)] {
    const hsize_t size = values.size();
    const Hdf5Handle space =
        p->handle(size == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &size, nullptr),
                  H5Sclose);
    p->attribute(group, name, hdf5Type<T>(), space, values.data());
  });
}

void Hdf5Writer::attribute(const std::string& group, const std::string& name,
                           const std::string& value) {
  parts_->later(0, [p = parts_.get(), group, name, value] {
    const Hdf5Handle type = p->stringType(value.size());
    const Hdf5Handle space = p->handle(H5Screate(H5S_SCALAR), H5Sclose);
    p->attribute(group, name, type.id(), space, value.c_str());
  });
}

void Hdf5Writer::write() {
  if (parts_->together)
    parts_->writeTogether();
  else
    parts_->writeAlone();
}

template void Hdf5Writer::array(const std::string&, Slice<double>);
template void Hdf5Writer::array(const std::string&, Slice<int>);
template void Hdf5Writer::array(const std::string&, Slice<long long>);
template void Hdf5Writer::array(const std::string&, Slice<unsigned char>);
template void Hdf5Writer::attribute(const std::string&, const std::string&,
                                    std::vector<int>);
template void Hdf5Writer::attribute(const std::string&, const std::string&,
                                    std::vector<double>);
template void Hdf5Writer::attribute(const std::string&, const std::string&,
                                    std::vector<unsigned long long>);

}  // namespace epafi::drivers
