// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_edit.h"
#include "core/export/rgl_fields.h"

namespace gonio::exports {

/// An RGL file with new colours: every field that did not change stays (16-bit numbers as 32-bit ones, which pbrt
/// reads), and the fields that a bundled file leaves out are added.
class RglRewrite {
 public:
  /// @param file the bytes from which `tables` were read; kept alive by the caller, as `edited`
  /// @throws FormatMismatch where they are no RGL file.
  RglRewrite(std::span<const std::byte> file, std::shared_ptr<const RglBrdf::Tables> tables, const EditedRgl& edited);

  /// The file itself where it has these colours, all fields and no change.
  std::vector<std::byte> bytes(RglColours colours, const std::string& description) const;
  /// The material of the RGB file.
  RglData data() const;

 private:
  bool has(RglColours colours) const;
  bool keeps(const std::string& name) const;
  std::vector<io::TensorField> newColours(RglColours colours) const;

  std::span<const std::byte> bytes_;
  io::TensorFile file_;
  std::shared_ptr<const RglBrdf::Tables> tables_;
  const EditedRgl& edited_;
};

}  // namespace gonio::exports
