// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <optional>

#include "app/gonio/interpolation/blend_ends.h"
#include "app/gonio/interpolation/blend_spaces.h"
#include "widgets/interpolation/blend_place.h"
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
class BlendPlaceEditor;
class BlendWells;

/// The content of the Interpolation dock: two to four materials, the place between them under the hand, the space in
/// which they are blended, all spaces side by side. While it is visible it decides what the preview shows. Nothing
/// of it changes the document until the blend is kept, which is an undo step.
class InterpolationPanel : public QWidget {
  Q_OBJECT

 public:
  InterpolationPanel(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr,
                     const StripPictures& pictures = {});

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

  /// Puts a material, by its id, in the next empty place: the last one when all are filled. Of several the places
  /// are made to fit, and each is filled anew; more than widgets::maxBlended fail.
  void take(const QStringList& ids);
  /// The document's material in the first place, if that is empty.
  void begin();
  /// The blend becomes the document's material: computed in the background, one undo step.
  void keep();
  /// No work is pending.
  bool isSettled() const;

  BlendWells& wells() const { return *m_wells; }
  BlendPlaceEditor& placeEditor() const { return *m_placeEditor; }
  BlendOverview& overview() const { return *m_overview; }
  QComboBox& spaceBox() const { return *m_spaceBox; }
  widgets::ModelBox& modelBox() const { return *m_modelBox; }
  QPushButton& keepButton() const { return *m_keep; }

 Q_SIGNALS:
  /// subject() is another one.
  void subjectChanged();
  void failed(const QString& title, const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  QSize sizeHint() const override;

 private:
  QWidget* buildChoice();
  void connectParts();
  void endsChanged();
  void materialChanged();
  /// The hand works here: the preview follows.
  void touched() { setShownInPreview(true); }
  void showEnds();
  void showPlace();
  void showExplanation();
  void showKeepable();

  Document& m_document;
  BackgroundTasks& m_tasks;
  BlendEnds m_ends;
  BlendSpaces m_spaces;
  QPointF m_place;
  int m_placeCount = widgets::minBlended;  ///< the number of materials for which m_place was chosen
  editing::InterpolationSpace m_space = editing::InterpolationSpace::linear;
  BlendWells* m_wells;
  BlendPlaceEditor* m_placeEditor;
  BlendOverview* m_overview;
  QComboBox* m_spaceBox;
  QLabel* m_modelLabel;
  widgets::ModelBox* m_modelBox;
  QCheckBox* m_show;
  QPushButton* m_keep;
};

}  // namespace gonio::app
