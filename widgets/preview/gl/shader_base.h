// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <QStringList>
#include <memory>

#include "core/brdf/brdf.h"

namespace gonio::widgets {

/// A base on the graphics card that is not a table: a measurement, a model or factors. The context must be current when
/// it is destroyed.
class ShaderBase {
 public:
  virtual ~ShaderBase() = default;
  /// Binds the textures and sets the uniforms of a shader compiled with addShaderBase().
  virtual void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) = 0;
};

/// Whether shaders/preview evaluates a BRDF in its native form: a table, or a BRDF that uploadShaderBase() accepts.
bool isShownNatively(const Brdf& base);

/// Adds the definitions and preamble files of the shader variant; none for a table, nor for factors, which EditChain
/// adds together with those of edits.
void addShaderBase(const Brdf& base, QStringList& definitions, QStringList& preamble);

/// Whether a base can be shown together with the tables of a blend, with at most 16 textures in total.
bool fitsBesideBlends(const Brdf& base);

/// Uploads a base, in a few ms. Null for a table and for a BRDF that the shader cannot evaluate.
std::shared_ptr<ShaderBase> uploadShaderBase(QOpenGLFunctions_4_1_Core& gl, const Brdf& base);

/// The data that uploadShaderBase() uploads: the same object for every incident direction of a measurement.
std::shared_ptr<const void> uploadedData(const std::shared_ptr<const Brdf>& base);

/// The definitions of the shader variant for the incident direction (shaders/preview/incident_direction.glsl).
QStringList incidentDefinitions(const Brdf& base);

}  // namespace gonio::widgets
