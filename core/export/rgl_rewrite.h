// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_edit.h"
#include "core/export/rgl_fields.h"

namespace gonio::exports {

/// Rewrites an RGL file with new colours. Other fields are copied (16-bit numbers become 32-bit ones, which pbrt
/// reads), and fields that a bundled file omits are added.
class RglRewrite {
 public:
  /// @param file the bytes from which `tables` were read. `file` and `edited` must outlive this object.
  /// @throws FormatMismatch if `file` is not an RGL file.
  RglRewrite(std::span<const std::byte> file, std::shared_ptr<const RglBrdf::Tables> tables, const EditedRgl& edited);

  /// The new file. Identical to the old file if that has this kind of colours and all fields, and no value has changed.
  std::vector<std::byte> bytes(RglColours colours, const std::string& description) const;
  /// The data of the RGB file.
  RglData data() const;

 private:
  bool has(RglColours colours) const;
  bool isCopied(const std::string& name) const;
  std::vector<io::TensorField> newColours(RglColours colours) const;

  std::span<const std::byte> bytes_;
  io::TensorFile file_;
  std::shared_ptr<const RglBrdf::Tables> tables_;
  const EditedRgl& edited_;
};

}  // namespace gonio::exports
