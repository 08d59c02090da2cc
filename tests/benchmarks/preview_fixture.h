// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QGuiApplication>
#include <QOpenGLFunctions>
#include <stdexcept>

#include "core/models/registry.h"
#include "tests/support/sphere_preview.h"
#include "tests/widgets/offscreen_context.h"

namespace gonio::benchmarks {

/// One application, context and renderer for all benchmarks of this program.
class PreviewFixture {
 public:
  static PreviewFixture& instance() {
    static PreviewFixture fixture;
    return fixture;
  }

  const std::shared_ptr<widgets::PreviewResources> resources = std::make_shared<widgets::PreviewResources>();
  widgets::PreviewRenderer renderer{resources};
  editing::DifferentialEdit edit;
  std::shared_ptr<const TabulatedBrdf> table;

  void show(const editing::EditList& edits = {}) {
    renderer.setSubject({widgets::EditedMaterial{table, edits}, lobe_});
  }

  /// Adds samples to each pixel and returns when they are drawn (a GPU would go on after the call).
  void accumulate(int samples) {
    renderer.accumulate(samples);
    QOpenGLContext::currentContext()->functions()->glFinish();
  }

 private:
  PreviewFixture() : application_(argumentCount_, arguments_) {
    context_ = std::make_unique<test::OffscreenContext>();
    if (!context_->isValid()) throw std::runtime_error("no OpenGL 4.1 core context");
    resources->initialize();
    renderer.initialize();
    const models::Model& model = models::findModel("ggx");
    edit.model = &model;
    edit.fitted = models::defaultParameters(model.spec());
    table = bakeTable(*model.instantiate(edit.fitted));
    lobe_ = std::make_shared<const TabulatedDensity>(*table);
    show();
    renderer.setSize({512, 512});
  }

  int argumentCount_ = 1;
  char name_[8] = "preview";
  char* arguments_[2] = {name_, nullptr};
  QGuiApplication application_;
  std::unique_ptr<test::OffscreenContext> context_;
  std::shared_ptr<const TabulatedDensity> lobe_;
};

}  // namespace gonio::benchmarks
