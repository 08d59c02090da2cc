// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/rgl_rewrite.h"

#include <algorithm>
#include <array>

#include "core/brdf/rgl_luminance.h"
#include "core/export/spectral_edit.h"

namespace gonio::exports {

namespace {

using io::TensorField;

TensorField ownField(const std::string& name, const io::Tensor& tensor) {
  if (tensor.type == io::TensorType::float16) return TensorField::floats(name, tensor.shape, tensor.floats());
  return {name, tensor.type, tensor.shape, {tensor.bytes.begin(), tensor.bytes.end()}};
}

/// Of a field with a slice for each incident direction.
std::vector<std::uint64_t> shapeOf(const ParameterGrid& incident, const SliceStack<float>& stack) {
  return {incident.phis().size(), incident.thetas().size(), stack.height, stack.width};
}

}  // namespace

RglRewrite::RglRewrite(std::span<const std::byte> file, std::shared_ptr<const RglBrdf::Tables> tables,
                       const EditedRgl& edited)
    : bytes_(file), file_(io::MemorySource(file)), tables_(std::move(tables)), edited_(edited) {}

bool RglRewrite::has(RglColours colours) const {
  return file_.contains(colours == RglColours::rgb ? "rgb" : "spectra");
}

bool RglRewrite::isCopied(const std::string& name) const {
  constexpr std::array<std::string_view, 5> rewritten{"description", "rgb", "spectra", "wavelengths", "visible_ndf"};
  return std::ranges::find(rewritten, name) == rewritten.end() && !(edited_.changed && name == "luminance");
}

std::vector<TensorField> RglRewrite::newColours(RglColours colours) const {
  const ParameterGrid& incident = tables_->data.incident;
  if (colours == RglColours::rgb || !tables_->data.spectra) return colourFields(edited_.rgb, incident, colours);
  const RglSpectra& own = *tables_->data.spectra;
  return {TensorField::floats("spectra", file_.floatField("spectra", 5).shape,
                              SpectralEdit(tables_->data, edited_.rgb).spectra()),
          TensorField::floats("wavelengths", {own.nanometres.size()}, own.nanometres)};
}

std::vector<std::byte> RglRewrite::bytes(RglColours colours, const std::string& description) const {
  const bool complete = file_.contains("vndf") && file_.contains("luminance");
  if (!edited_.changed && has(colours) && complete) return {bytes_.begin(), bytes_.end()};
  std::vector<TensorField> fields{TensorField::text("description", file_.text("description") + "\n" + description)};
  for (const auto& [name, tensor] : file_.fields())
    if (isCopied(name)) fields.push_back(ownField(name, tensor));
  const RglData data = this->data();
  if (!file_.contains("vndf"))
    fields.push_back(TensorField::floats("vndf", shapeOf(data.incident, data.vndf), data.vndf.values));
  if (edited_.changed || !file_.contains("luminance"))
    fields.push_back(TensorField::floats("luminance", shapeOf(data.incident, data.luminance), data.luminance.values));
  for (TensorField& field : newColours(colours)) fields.push_back(std::move(field));
  return io::encodeTensorFile(fields);
}

RglData RglRewrite::data() const {
  RglData data = wholeData(*tables_);
  data.rgb = edited_.rgb;
  data.luminance = samplingLuminance(edited_.rgb);
  return data;
}

}  // namespace gonio::exports
