// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <pybind11/numpy.h>

#include <filesystem>
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

/// Calls work(begin, a, b) for blocks of rows of two arrays of the same shape (..., 3), on all cores, without the GIL.
/// `a` and `b` are contiguous copies of at most `pairBlock` rows from row `begin` on.
/// @throws Error if the numbers of rows differ.
using PairWork = std::function<void(std::size_t begin, std::span<const glm::dvec3> a, std::span<const glm::dvec3> b)>;
inline constexpr std::size_t pairBlock = 512;
void forPairs(const Vectors& a, const Vectors& b, const PairWork& work);

/// @throws Error that names the array and the row if the length of a direction differs from 1 by more than 1e-5.
void checkUnit(std::span<const glm::dvec3> directions, std::size_t firstRow, const char* name);

/// A new array with `last` numbers for each row of `like`; 0: one number per row, without a last dimension.
py::array_t<double> arrayLike(const Vectors& like, py::ssize_t last);

/// A read-only array over existing memory, without a copy. It shares `owner`, which owns `data`.
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
/// Rows of three numbers. @throws Error if the shape is not (n, 3).
std::vector<Rgb> toRgb(const Vectors& array, const char* name);
/// (height, width, 3) of float32, without a copy, and alpha (height, width) or None.
py::tuple toArrays(Image image);

/// Text for people, of a file or with a path in it. Bytes that are not UTF-8 become \xNN.
py::str toText(std::string_view text);
py::list toTexts(const std::vector<std::string>& texts);
/// A path as Python decodes it: bytes that are not UTF-8 become surrogates, so that it opens the same file.
py::str toPath(const std::filesystem::path& path);

/// JSON as dicts, lists, strings and numbers; numbers that are not finite are unchanged.
py::object toPython(const nlohmann::json& json);

}  // namespace gonio::python
