// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>

#include "app/gonio/interpolation/blend_slots.h"
#include "app/gonio/interpolation/blend_spaces.h"
#include "widgets/interpolation/blend_position.h"
#include "widgets/preview/gl/preview_subject.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace gonio::widgets {
class ModelBox;
}

namespace gonio::app {

class BlendOverview;
class BlendPositionEditor;
class BlendSlots;

/// The content of the Interpolation dock: two to four materials, an editor for the position between them, the
/// interpolation space, and a comparison of all spaces. While it is visible it can replace the subject of the preview.
/// The document does not change until the blend is opened as a material, which is an undo step.
class InterpolationPanel : public QWidget {
  Q_OBJECT

 public:
  InterpolationPanel(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr,
                     const StripPictures& pictures = {});

  /// The subject that the preview shows instead of the document's material; nullopt while the panel is hidden, "Show in
  /// the preview" is off, or there is no blend.
  std::optional<widgets::PreviewSubject> subject() const;
  /// E.g. "40 % nickel, 60 % chrome (Linear)".
  QString description() const;

  BlendMaterials& materials() { return m_materials; }
  BlendSpaces& spaces() { return m_spaces; }
  interpolation::InterpolationSpace space() const { return m_space; }
  QPointF position() const { return m_position; }
  std::vector<double> weights() const;
  /// Moves the position, as the user does.
  void moveTo(const QPointF& position);
  void setShownInPreview(bool shown);

  /// One id: puts the material in the next empty slot; adds a slot if all are filled. Several ids: adjusts the number
  /// of slots and fills all of them. Refuses more than widgets::maxBlended materials.
  void useMaterials(const QStringList& ids);
  /// Puts the document's material in the first slot, if that is empty.
  void begin();
  /// Makes the blend the document's material: computed in the background, one undo step.
  void openAsMaterial();
  /// Whether no work is pending.
  bool isSettled() const;

 Q_SIGNALS:
  /// subject() changed.
  void subjectChanged();
  void failed(const QString& title, const QString& text);
  /// A material to open in the document's place, and the name of the undo step.
  void materialMade(const LoadedMaterialPtr& material, const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  QSize sizeHint() const override;

 private:
  QWidget* buildChoice();
  void connectParts();
  void blendMaterialsChanged();
  void materialChanged();
  void setSpace(interpolation::InterpolationSpace space);
  /// The user works in this panel, so the preview shows the blend.
  void touched() { setShownInPreview(true); }
  void showMaterials();
  void showPosition();
  void showExplanation();
  void showOpenable();
  /// The cost of the blend at the present weights; null until it is measured.
  const study::UseCost* presentCost() const;
  void measureCost();

  Document& m_document;
  BackgroundTasks& m_tasks;
  BlendMaterials m_materials;
  BlendSpaces m_spaces;
  QPointF m_position;
  int m_positionCount = widgets::minBlended;  ///< the number of materials for which m_position was chosen
  interpolation::InterpolationSpace m_space = interpolation::InterpolationSpace::linear;
  BlendSlots* m_slots;
  BlendPositionEditor* m_positionEditor;
  BlendOverview* m_overview;
  QComboBox* m_spaceBox;
  QLabel* m_modelLabel;
  widgets::ModelBox* m_modelBox;
  QCheckBox *m_preserveDetail, *m_show;
  QPushButton* m_open;
  /// A cost and what it was measured of.
  struct MeasuredCost {
    widgets::PreparedBlendPtr blend;
    std::vector<double> weights;
    study::UseCost cost;
  };
  std::optional<MeasuredCost> m_measured;
  QTimer m_rest;  ///< until the position has rested long enough to measure the cost there
};

}  // namespace gonio::app
