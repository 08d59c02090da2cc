// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/formats.h"

std::span<const gonio::materials::MaterialFormat* const> gonio::materials::materialFormats() {
  return formats::allFormats;
}
