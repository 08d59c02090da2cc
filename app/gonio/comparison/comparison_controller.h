// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <array>
#include <optional>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "app/gonio/document/material_code.h"
#include "widgets/preview/gl/preview_comparison.h"
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::widgets {
class ComparisonBar;
class PreviewWidget;
}  // namespace gonio::widgets

namespace gonio::app {

/// What may take the place of the edited material in the preview; the first that is there does.
enum class StandIn {
  representation,  ///< of the material, while the user looks at it
  blend            ///< under the hand
};

/// A spectral material at one wavelength.
struct WavelengthSubjects {
  LoadedMaterialPtr material;
  double nanometres;
  widgets::PreviewSubject measured, edited;
};

/// Decides what the preview shows: the edited material, or two of the document's sides and another material against
/// each other. It keeps the preview, the bar and the document together. What is compared is no part of the document.
class ComparisonController : public QObject {
  Q_OBJECT

 public:
  ComparisonController(Document& document, BackgroundTasks& tasks, widgets::PreviewWidget& preview,
                       widgets::ComparisonBar& bar, QObject* parent = nullptr);

  /// Reads another material in the background and puts it against the document's, in a split when nothing is compared.
  void openReference(const QString& path);
  const LoadedMaterialPtr& reference() const { return m_reference; }

  /// Off, or the mode that was used last.
  void toggle();
  void setComparison(const widgets::PreviewComparison& comparison);
  const widgets::PreviewComparison& comparison() const { return m_comparison; }
  void setSides(widgets::ComparedSubject first, widgets::ComparedSubject second);
  std::array<widgets::ComparedSubject, 2> sides() const { return m_sides; }

  /// The edited material stands on this code of the document's material from now on; null: on the measurement.
  void setCode(std::shared_ptr<const MaterialCode> code);
  /// Null when it is of another material.
  const MaterialCode* code() const;

  /// The measured and the edited material are shown at a wavelength from now on; nothing: at all of them.
  void setWavelength(std::optional<WavelengthSubjects> subjects);

  widgets::PreviewSubject subject(widgets::ComparedSubject side) const;
  /// Shows something else in the place of the edited material, until it is taken back.
  void setStandIn(StandIn kind, std::optional<widgets::PreviewSubject> subject, const QString& name);
  /// Of those that are there, the one that is shown; nothing: the edited material.
  std::optional<StandIn> standIn() const;
  QString standInName() const;
  /// Asks whoever put the stand-in there to take it back; nothing where there is none.
  void dismissStandIn();

  /// A subject that is none of the document.
  struct Named {
    widgets::PreviewSubject subject;
    QString name;
  };
  /// Puts any two subjects against each other, in the places of the edited material and of the reference: until
  /// dismissStandIn(), another choice of sides, the end of the comparison or any change of the document.
  void setPair(const std::array<Named, 2>& pair);
  bool hasPair() const { return m_pair.has_value(); }
  /// Whether something else than the document's material is shown: dismissStandIn() brings it back.
  bool isReplaced() const { return m_pair || standIn(); }

  /// sourceKind(), "Fit: GGX", "Edited", the name of a material without edits, "Encoded", the name of the reference;
  /// empty while it is not there.
  QString name(widgets::ComparedSubject side) const;

 Q_SIGNALS:
  /// The sides, or what stands on one of them.
  void subjectsChanged();
  void comparisonChanged();
  /// The user wants to see the material again.
  void standInDismissed(gonio::app::StandIn kind);
  /// The user wants to choose another material.
  void referenceWanted();
  void failed(const QString& title, const QString& text);

 private:
  void refresh();
  void endPair();
  /// Of the pair; null where there is none or it has nothing on this side.
  const Named* pairSide(widgets::ComparedSubject side) const;
  void showBanner();
  /// Null for other materials than the document's.
  const WavelengthSubjects* wavelength() const;
  bool isEdited() const;
  void chooseUsualSides();

  Document& m_document;
  BackgroundTasks& m_tasks;
  widgets::PreviewWidget& m_preview;
  widgets::ComparisonBar& m_bar;
  widgets::PreviewComparison m_comparison;
  widgets::CompareMode m_lastMode = widgets::CompareMode::split;
  std::array<widgets::ComparedSubject, 2> m_sides{widgets::ComparedSubject::edited, widgets::ComparedSubject::measured};
  bool m_sidesChosen = false;  ///< by the user; otherwise the most informative ones
  LoadedMaterialPtr m_reference;
  struct Pair {
    std::array<Named, 2> subjects;
    std::array<widgets::ComparedSubject, 2> sidesBefore;
    widgets::CompareMode modeBefore;
  };
  std::optional<Pair> m_pair;
  struct Replacement {
    std::optional<widgets::PreviewSubject> subject;
    QString name;
  };
  std::array<Replacement, 2> m_standIns;  ///< by StandIn
  std::shared_ptr<const MaterialCode> m_code;
  std::optional<WavelengthSubjects> m_wavelength;
};

}  // namespace gonio::app
