// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <string_view>

namespace gonio {

struct BundledScene {
  std::string_view name, json;
};
/// resources/scenes/*.json, in the order of display.
std::span<const BundledScene> bundledScenes();

}  // namespace gonio
