// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"
#include "core/export/view_lobes.h"

namespace gonio::exports {

/// NAME_blender.py: a Python script that creates the material of fitViewLobes() in Blender.
ExportTarget blenderTarget();

/// The script. @param name of the material. @param origin of the material.
std::string blenderScript(const ViewLobes& lobes, const std::string& name, const std::string& origin);

}  // namespace gonio::exports
