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

/// Subjects that can replace the edited material in the preview, in descending priority.
enum class StandIn {
  match,           ///< the proposed match with the reference image
  representation,  ///< a representation of the material
  blend            ///< the current blend of the Blend panel
};

/// A spectral material at one wavelength.
struct WavelengthSubjects {
  LoadedMaterialPtr material;
  double nanometres;
  widgets::PreviewSubject measured, edited;
};

/// Controls what the preview shows: the edited material, or a comparison of two of these: the measurement, its fit, the
/// edited material, and a reference. Synchronises preview, bar and document. The comparison is not part of the
/// document.
class ComparisonController : public QObject {
  Q_OBJECT

 public:
  ComparisonController(Document& document, BackgroundTasks& tasks, widgets::PreviewWidget& preview,
                       widgets::ComparisonBar& bar, QObject* parent = nullptr);

  /// Reads another material in the background and compares it with the document's, in a split view if the comparison is
  /// off.
  void openReference(const QString& path);
  const LoadedMaterialPtr& reference() const { return m_reference; }

  /// Switches the comparison off, or on in the last mode.
  void toggle();
  void setComparison(const widgets::PreviewComparison& comparison);
  const widgets::PreviewComparison& comparison() const { return m_comparison; }
  void setSides(widgets::ComparedSubject first, widgets::ComparedSubject second);
  std::array<widgets::ComparedSubject, 2> sides() const { return m_sides; }

  /// Uses this code of the document's material as the base of the edited material; null: the measurement.
  void setCode(std::shared_ptr<const MaterialCode> code);
  /// Null if the code belongs to another material.
  const MaterialCode* code() const;

  /// Shows the measured and the edited material at one wavelength; nullopt: in RGB.
  void setWavelength(std::optional<WavelengthSubjects> subjects);

  widgets::PreviewSubject subject(widgets::ComparedSubject side) const;
  /// Shows a subject in place of the edited material, until it is set to nullopt.
  void setStandIn(StandIn kind, std::optional<widgets::PreviewSubject> subject, const QString& name);
  /// The stand-in that is shown; nullopt: the edited material.
  std::optional<StandIn> standIn() const;
  QString standInName() const;
  /// Ends the comparison started by setPair(). Without one, emits standInDismissed() or codeDismissed(), so that the
  /// owner of the stand-in or of the code removes it.
  void dismissStandIn();

  /// A subject that is not part of the document.
  struct Named {
    widgets::PreviewSubject subject;
    QString name;
  };
  /// Compares any two subjects, in place of the edited material and the reference, until dismissStandIn(), another
  /// choice of sides, the end of the comparison or any change of the document.
  void setPair(const std::array<Named, 2>& pair);
  /// Whether something other than the document's material is shown, so that dismissStandIn() has an effect.
  bool isReplaced() const { return m_pair || standIn(); }

  /// Name of what a side shows, e.g. "Measured" (sourceKind()), "Fit: GGX", "Edited", or the name of the reference;
  /// empty if the side does not exist.
  QString name(widgets::ComparedSubject side) const;

 Q_SIGNALS:
  /// The sides or their subjects changed.
  void subjectsChanged();
  void comparisonChanged();
  /// The user wants to see the document's material again.
  void standInDismissed(gonio::app::StandIn kind);
  /// The user wants to see the measurement in place of the code.
  void codeDismissed();
  /// The user wants to choose another material.
  void referenceRequested();
  void failed(const QString& title, const QString& text);

 private:
  void refresh();
  void endPair();
  /// The subject of the pair on this side; null if there is none.
  const Named* pairSide(widgets::ComparedSubject side) const;
  void showBanner();
  /// Null if the wavelength belongs to another material than the document's.
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
  bool m_sidesChosen = false;  ///< by the user; if not, the most informative sides are chosen
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
  std::array<Replacement, 3> m_standIns;  ///< indexed by StandIn
  std::shared_ptr<const MaterialCode> m_code;
  std::optional<WavelengthSubjects> m_wavelength;
};

}  // namespace gonio::app
