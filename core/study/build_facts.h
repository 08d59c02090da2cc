// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

namespace gonio::study {

// Version, compiler and flags of this build, from CMake (build_facts.cpp.in).
extern const char* const buildVersion;
extern const char* const buildCompiler;
extern const char* const buildFlags;

}  // namespace gonio::study
