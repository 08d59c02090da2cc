// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include "app/gonio/document/document_controller.h"
#include "app/gonio/interpolation/blend_overview.h"
#include "app/gonio/interpolation/blend_slots.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "core/models/registry.h"
#include "tests/app/gonio/patience.h"
#include "tests/widgets/child.h"
#include "widgets/interpolation/material_slot_widget.h"

namespace gonio::app::test_support {

/// One coefficient in place of the code of a material, where what it decodes to does not matter: encoding takes a
/// second.
inline std::shared_ptr<const dictionary::SparseCode> anyCode() {
  dictionary::SparseCode code{.grid = HalfDifferenceGrid()};
  for (dictionary::ChannelCode& channel : code.channels) channel.coefficients = {{.index = 0, .value = 1}};
  return std::make_shared<const dictionary::SparseCode>(code);
}

inline LoadedMaterialPtr greyMaterial(const char* name, double albedo) {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.name = name;
  loaded->material.source.path = std::string("/nowhere/") + name + ".binary";
  loaded->material.source.sha256 = std::string(64, 'a');
  loaded->material.code = anyCode();
  const HalfDifferenceGrid grid{12, 12, 12};
  loaded->base = std::make_shared<const TabulatedBrdf>(
      grid, std::vector<TabulatedBrdf::Value>(grid.size(), glm::vec3(float(albedo / pi))),
      std::vector<std::uint8_t>(grid.size(), 1));
  loaded->material.brdf = loaded->base;
  return loaded;
}

inline double normalValue(const Brdf& brdf) { return pi * brdf.evaluate({0, 0, 1}, {0, 0, 1}).r; }

/// Enough to distinguish materials.
inline constexpr StripPictures smallPictures{.side = 24, .samples = 2};

struct Editor {
  BackgroundTasks tasks;
  Document document;
  DocumentController controller{document, tasks};
  InterpolationPanel panel{document, tasks, nullptr, smallPictures};

  Editor() {
    QObject::connect(&panel, &InterpolationPanel::materialMade, &controller, &DocumentController::openInMemory);
    panel.resize(1300, 400);
    panel.show();
  }
  QPushButton& openButton() const { return *test::child<QPushButton>(panel, "Open as Material"); }
  widgets::MaterialSlotWidget& slotWidget(int slot) const { return panel.findChild<BlendSlots*>()->slotWidget(slot); }
  bool isSettled() const { return panel.isSettled() && tasks.isIdle(); }
  /// Opens a grey and takes it as it is.
  void fill(int slot, const char* name, double albedo) {
    document.setMaterial(greyMaterial(name, albedo));
    test::child<QToolButton>(slotWidget(slot), "Current")->click();
    QTRY_VERIFY_WITH_TIMEOUT(panel.materials().at(slot), patienceMilliseconds);
  }
};

}  // namespace gonio::app::test_support
