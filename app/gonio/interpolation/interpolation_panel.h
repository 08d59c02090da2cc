// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <optional>

#include "app/gonio/interpolation/blend_ends.h"
#include "app/gonio/interpolation/blend_spaces.h"
#include "widgets/preview/gl/preview_subject.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace gonio::widgets {
class BlendPad;
class BlendStrip;
class MaterialWell;
class NumberField;
class ParameterSlider;
}  // namespace gonio::widgets

namespace gonio::app {

/// The content of the Interpolation dock: two to four materials, the place between them under the hand, the space in
/// which they are blended, all spaces side by side. While it is in sight it tells what the preview is to show. Nothing
/// of it changes the document until the blend is kept, which is an undo step.
class InterpolationPanel : public QWidget {
  Q_OBJECT

 public:
  InterpolationPanel(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  /// What the preview is to show instead of the document's material; nothing while the panel is out of sight, is not
  /// shown in the preview, or has nothing to show.
  std::optional<widgets::PreviewSubject> subject() const;
  /// "40 % nickel, 60 % chrome (Linear)"
  QString description() const;

  BlendEnds& ends() { return m_ends; }
  BlendSpaces& spaces() { return m_spaces; }
  editing::InterpolationSpace space() const { return m_space; }
  void setSpace(editing::InterpolationSpace space);
  QPointF place() const { return m_place; }
  std::vector<double> weights() const;
  /// Moves the point, as the hand does.
  void moveTo(const QPointF& place);
  void setShownInPreview(bool shown);
  bool isShownInPreview() const;

  /// Puts a material, by its id, in the next empty place: the last one when all are filled.
  void take(const QString& id);
  /// The document's material in the first place, if that is empty.
  void begin();
  /// The blend becomes the document's material: computed in the background, one undo step.
  void keep();
  /// Nothing is to come.
  bool isSettled() const;

  widgets::MaterialWell& well(int place) const { return *m_wells[std::size_t(place)]; }
  widgets::ParameterSlider& slider() const { return *m_slider; }
  widgets::NumberField& number() const { return *m_number; }
  widgets::BlendPad& pad() const { return *m_pad; }
  widgets::BlendStrip& strip() const { return *m_strip; }
  QComboBox& spaceBox() const { return *m_spaceBox; }
  QPushButton& keepButton() const { return *m_keep; }
  QPushButton& drawButton() const { return *m_draw; }

 Q_SIGNALS:
  /// subject() is another one.
  void subjectChanged();
  void failed(const QString& title, const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  QSize sizeHint() const override;

 private:
  QWidget* buildWells();
  QWidget* buildPlace();
  QWidget* buildChoice();
  void connectWells();
  void connectParts();
  void endsChanged();
  void materialChanged();
  void askForFile(int place);
  /// The hand works here: the preview follows.
  void touched();
  void showWells();
  void showPlace();
  void showStrip();
  void showRow(editing::InterpolationSpace space);
  void request();

  Document& m_document;
  BackgroundTasks& m_tasks;
  BlendEnds m_ends;
  BlendSpaces m_spaces;
  QPointF m_place;
  editing::InterpolationSpace m_space = editing::InterpolationSpace::linear;
  std::vector<widgets::MaterialWell*> m_wells;
  QToolButton *m_swap, *m_add;
  QStackedWidget* m_places;
  widgets::ParameterSlider* m_slider;
  widgets::NumberField* m_number;
  widgets::BlendPad* m_pad;
  QComboBox* m_spaceBox;
  QCheckBox* m_show;
  QLabel* m_explanation;
  QPushButton *m_keep, *m_draw;
  widgets::BlendStrip* m_strip;
};

}  // namespace gonio::app
