#pragma once

namespace epafi::bem {

/// While it lives, each call of OpenBLAS runs on the thread that makes it; another BLAS is
/// left alone.  For OpenMP's threads that call BLAS for many small matrices: where each call
/// has threads of its own they wait for one another, twenty times as long as they compute.
///
/// Not for several threads at once: it is made and ends outside of their loops.
class SerialBlas {
 public:
  SerialBlas();
  ~SerialBlas();
  SerialBlas(const SerialBlas&) = delete;
  SerialBlas& operator=(const SerialBlas&) = delete;

 private:
  int before_ = 0;  ///< threads of OpenBLAS; 0: it is not there
};

}  // namespace epafi::bem
