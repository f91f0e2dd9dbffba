#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace bodyline::explore {

/// An open object of the HDF5 library. The library knows one thread at a time: whoever makes these
/// is the only one who does.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);

  /// Throws std::runtime_error when the library gave no object.
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {
    if (id < 0) throw std::runtime_error("the HDF5 library refuses");
  }
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, hid_t(-1))), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// Throws std::runtime_error when a call of the library failed.
inline void hdf5_check(herr_t result) {
  if (result < 0) throw std::runtime_error("the HDF5 library refuses");
}

/// While one lives, the library prints nothing when a call fails.
class Hdf5Quiet {
 public:
  Hdf5Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  Hdf5Quiet(const Hdf5Quiet&) = delete;
  Hdf5Quiet& operator=(const Hdf5Quiet&) = delete;
  ~Hdf5Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

}  // namespace bodyline::explore
