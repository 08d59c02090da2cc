// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <QStringList>
#include <memory>

#include "core/brdf/brdf.h"

namespace gonio::widgets {

/// A measurement that is no table, on the graphics card. Freed with its last user, in whose hands the context must be
/// current.
class ShaderBase {
 public:
  virtual ~ShaderBase() = default;
  /// Binds textures and sets uniforms of a shader that is compiled with addShaderBase().
  virtual void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) = 0;
};

/// Whether shaders/preview evaluates a BRDF in its own form: a table, or one that uploadShaderBase() takes.
bool isShownNatively(const Brdf& base);

/// What the shader is compiled for; nothing for a table, and for factors, which EditChain adds beside those of edits.
void addShaderBase(const Brdf& base, QStringList& definitions, QStringList& preamble);

/// Whether a measurement can be shown beside the tables of a blend: its textures and theirs are at most 16.
bool fitsBesideBlends(const Brdf& base);

/// Some ms. Null for a table and for what the shader does not know.
std::shared_ptr<ShaderBase> uploadShaderBase(QOpenGLFunctions_4_1_Core& gl, const Brdf& base);

/// What uploadShaderBase() uploads: the same object for a measurement in any order of its directions.
std::shared_ptr<const void> uploadedData(const std::shared_ptr<const Brdf>& base);

/// What the shader is compiled for where a measurement can be read in any order (shaders/preview/incident_slot.glsl).
QStringList incidentDefinitions(const Brdf& base);

}  // namespace gonio::widgets
