// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "python/bindings/arrays.h"

#include <algorithm>
#include <array>

#include "core/math/parallel.h"
#include "core/support/text.h"

namespace gonio::python {

namespace {

/// The rows of an array of shape (..., 3) with any strides.
class Rows {
 public:
  explicit Rows(const Vectors& array) : data_(reinterpret_cast<const char*>(array.data())) {
    const py::ssize_t last = array.ndim() - 1;
    if (last < 0 || array.shape(last) != 3) throw Error("expected an array of shape (..., 3)");
    inner_ = array.strides(last);
    for (py::ssize_t d = 0; d < last; ++d) add(std::size_t(array.shape(d)), array.strides(d));
    if (shape_.empty()) add(1, 0);
  }
  std::size_t count() const { return count_; }

  /// Rows [begin, begin + rows.size()).
  void read(std::size_t begin, std::span<glm::dvec3> rows) const {
    while (!rows.empty()) {
      // The rows from `begin` to the end of the last dimension, which have one stride.
      const char* row = data_;
      std::size_t rest = begin;
      const std::size_t run = std::min(rows.size(), shape_.back() - begin % shape_.back());
      for (std::size_t d = shape_.size(); d-- > 0; rest /= shape_[d])
        row += py::ssize_t(rest % shape_[d]) * strides_[d];
      for (glm::dvec3& value : rows.first(run)) {
        value = {number(row), number(row + inner_), number(row + 2 * inner_)};
        row += strides_.back();
      }
      begin += run;
      rows = rows.subspan(run);
    }
  }

 private:
  /// Appends a dimension; merges it with the previous one if both are contiguous.
  void add(std::size_t size, py::ssize_t stride) {
    count_ *= size;
    if (!shape_.empty() && strides_.back() == py::ssize_t(size) * stride) {
      shape_.back() *= size;
      strides_.back() = stride;
    } else {
      shape_.push_back(size);
      strides_.push_back(stride);
    }
  }
  static double number(const char* at) { return *reinterpret_cast<const double*>(at); }

  const char* data_;
  std::vector<std::size_t> shape_;
  std::vector<py::ssize_t> strides_;
  py::ssize_t inner_ = 0;
  std::size_t count_ = 1;
};

/// Minimum number of pairs for which the calling thread checks for Ctrl+C, since that requires starting another thread.
constexpr std::size_t interruptiblePairs = 1 << 16;

}  // namespace

void forPairs(const Vectors& a, const Vectors& b, const PairWork& work) {
  const Rows first(a), second(b);
  if (first.count() != second.count()) throw Error("the arrays have different shapes");
  const auto all = [&](const TaskControl& control) {
    parallelForBlocks(
        first.count(), pairBlock,
        [&](std::size_t begin, std::size_t end) {
          std::array<glm::dvec3, pairBlock> rowsOfA, rowsOfB;
          const std::span usedA(rowsOfA.data(), end - begin), usedB(rowsOfB.data(), end - begin);
          first.read(begin, usedA);
          second.read(begin, usedB);
          work(begin, usedA, usedB);
        },
        control);
  };
  if (first.count() >= interruptiblePairs) {
    runTask(py::none(), all);
  } else {
    const py::gil_scoped_release released;
    all({});
  }
}

void checkUnit(std::span<const glm::dvec3> directions, std::size_t firstRow, const char* name) {
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double squared = glm::dot(directions[i], directions[i]);
    // Negated, so that NaN is rejected too.
    if (!(std::abs(squared - 1) <= 2e-5))
      throw Error(std::string(name) + ": found a direction of length " + numberText(std::sqrt(squared)) + " (number " +
                  std::to_string(firstRow + i) + "), expected unit vectors");
  }
}

py::array_t<double> arrayLike(const Vectors& like, py::ssize_t last) {
  std::vector<py::ssize_t> shape(like.shape(), like.shape() + like.ndim() - 1);
  if (last > 0) shape.push_back(last);
  return py::array_t<double>(shape);
}

py::array_t<double> toArray(std::span<const double> values) {
  return py::array_t<double>(py::ssize_t(values.size()), values.data());
}

py::array_t<double> toArray(std::span<const Rgb> values) {
  return py::array_t<double>({py::ssize_t(values.size()), py::ssize_t(3)},
                             reinterpret_cast<const double*>(values.data()));
}

std::vector<Rgb> toRgb(const Vectors& array, const char* name) {
  if (array.ndim() != 2 || array.shape(1) != 3) throw Error(std::string(name) + ": expected an array of shape (n, 3)");
  std::vector<Rgb> values(std::size_t(array.shape(0)));
  Rows(array).read(0, values);
  return values;
}

py::tuple toArrays(Image image) {
  const auto held = std::make_shared<Image>(std::move(image));
  const py::ssize_t height = held->height, width = held->width;
  py::object alpha = py::none();
  if (!held->alpha.empty()) alpha = view(held->alpha.data(), {height, width}, held);
  return py::make_tuple(view(reinterpret_cast<const float*>(held->pixels.data()), {height, width, 3}, held), alpha);
}

py::str toText(std::string_view text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), py::ssize_t(text.size()), "backslashreplace"));
}

py::list toTexts(const std::vector<std::string>& texts) {
  py::list list;
  for (const std::string& text : texts) list.append(toText(text));
  return list;
}

py::str toPath(const std::filesystem::path& path) {
  const std::string& name = path.native();
  return py::reinterpret_steal<py::str>(PyUnicode_DecodeFSDefaultAndSize(name.data(), py::ssize_t(name.size())));
}

py::object toPython(const nlohmann::json& json) {
  using Type = nlohmann::json::value_t;
  switch (json.type()) {
    case Type::object: {
      py::dict result;
      for (const auto& [key, value] : json.items()) result[py::str(key)] = toPython(value);
      return result;
    }
    case Type::array: {
      py::list result;
      for (const auto& value : json) result.append(toPython(value));
      return result;
    }
    case Type::string:
      return py::str(json.get<std::string>());
    case Type::boolean:
      return py::bool_(json.get<bool>());
    case Type::number_integer:
    case Type::number_unsigned:
      return py::int_(json.get<std::int64_t>());
    case Type::number_float:
      return py::float_(json.get<double>());
    default:
      return py::none();
  }
}

}  // namespace gonio::python
