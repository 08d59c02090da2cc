// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <pybind11/numpy.h>

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "core/math/image.h"
#include "core/math/types.h"
#include "python/bindings/task.h"

namespace gonio::python {

using Vectors = py::array_t<double>;  ///< rows of three numbers: shape (..., 3), any strides

/// Calls work(begin, end, a, b) for blocks of the rows of two arrays of one shape (..., 3), on all cores, without the
/// GIL. `a` and `b` are rows [begin, end) of the arrays, copied together: at most `pairBlock`.
/// @throws Error where the shapes differ.
using PairWork = std::function<void(std::size_t begin, std::span<const glm::dvec3> a, std::span<const glm::dvec3> b)>;
inline constexpr std::size_t pairBlock = 512;
void forPairs(const Vectors& a, const Vectors& b, const PairWork& work);

/// @throws Error that names the array and the row where a direction's length is not 1 to 1e-5.
void checkUnit(std::span<const glm::dvec3> directions, std::size_t firstRow, const char* name);

/// A new array of the shape of rows of `like`, with `last` numbers per row; a number per row where that is 0.
py::array_t<double> arrayLike(const Vectors& like, py::ssize_t last);

/// Numbers that stay where they are: read-only, `owner` lives as long as the array.
template <typename Value>
py::array view(const Value* data, const std::vector<py::ssize_t>& shape, std::shared_ptr<const void> owner,
               const py::dtype& type = py::dtype::of<Value>()) {
  const py::capsule keeper(new std::shared_ptr<const void>(std::move(owner)),
                           [](void* held) { delete static_cast<std::shared_ptr<const void>*>(held); });
  py::array array(type, shape, data, keeper);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::array_t<double> toArray(std::span<const double> values);
py::array_t<double> toArray(std::span<const Rgb> values);
/// Rows of three numbers. @throws Error when the shape is another than (n, 3).
std::vector<Rgb> toRgb(const Vectors& array, const char* name);
/// (height, width, 3) of float32, without a copy, and alpha (height, width) or None.
py::tuple toArrays(Image image);

/// Dictionaries, lists and numbers; numbers that are not finite stay as they are.
py::object toPython(const nlohmann::json& json);

}  // namespace gonio::python
