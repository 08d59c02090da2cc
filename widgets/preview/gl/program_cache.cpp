// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/program_cache.h"

#include <algorithm>

#include "core/support/error.h"
#include "widgets/preview/gl/flat_uniforms.h"
#include "widgets/preview/gl/shader_library.h"

namespace gonio::widgets {

namespace {

bool link(QOpenGLShaderProgram& program, const PassShaders& shaders) {
  return program.addShaderFromSourceCode(QOpenGLShader::Vertex, shaders.vertex) &&
         program.addShaderFromSourceCode(QOpenGLShader::Fragment, shaders.fragment) && program.link();
}

/// Null where the driver refuses it.
std::unique_ptr<QOpenGLShaderProgram> linkedWithFlatUniforms(const PassShaders& shaders, int vectors) {
  auto program = std::make_unique<QOpenGLShaderProgram>();
  return link(*program, withFlatUniforms(shaders, vectors)) ? std::move(program) : nullptr;
}

std::unique_ptr<QOpenGLShaderProgram> linked(const PassShaders& shaders, const QString& name) {
  auto program = std::make_unique<QOpenGLShaderProgram>();
  if (!link(*program, shaders))
    throw Error("shader " + name.toStdString() +
                " could not be compiled by the graphics driver: " + program->log().toStdString());
  return program;
}

}  // namespace

void ProgramCache::setFlatVectors(std::optional<int> vectors) {
  flatVectors_ = vectors;
  programs_.clear();
}

QOpenGLShaderProgram& ProgramCache::program(const QString& fragment, const QStringList& definitions,
                                            const QStringList& preamble) {
  const QString key = fragment + ' ' + definitions.join(' ');
  auto known = programs_.find(key);
  if (known == programs_.end()) {
    auto program = compiled(fragment, definitions, preamble);
    makeRoom();
    known = programs_.emplace(key, LinkedProgram{std::move(program)}).first;
  }
  known->second.lastUse = ++uses_;
  return *known->second.program;
}

void ProgramCache::makeRoom() {
  if (programs_.size() < mostPrograms) return;
  programs_.erase(std::ranges::min_element(programs_, {}, [](const auto& entry) { return entry.second.lastUse; }));
}

std::unique_ptr<QOpenGLShaderProgram> ProgramCache::compiled(const QString& fragment, const QStringList& definitions,
                                                             const QStringList& preamble) const {
  if (compileListener_) compileListener_();
  const PassShaders shaders{assembleShader("preview/fullscreen.vert"), assembleShader(fragment, definitions, preamble)};
  if (flatVectors_)
    if (auto program = linkedWithFlatUniforms(shaders, *flatVectors_)) return program;
  return linked(shaders, fragment);
}

}  // namespace gonio::widgets
