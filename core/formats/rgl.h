// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/materials/encode.h"
#include "core/rgl/rgl_encoder.h"

namespace gonio::formats {

/// Both files of a material as RGL files: materials::encode() returns one of them. @throws as materials::encode().
rgl::EncodedRgl encodeRgl(const materials::EditedMaterial& material, const materials::EncodeOptions& options = {},
                          const TaskControl& control = {});
/// What such a pair of files loses, as sentences for the user.
std::vector<std::string> lossesOf(const rgl::EncodedRgl& files);

}  // namespace gonio::formats
