// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "app/gonio/acquisition/photograph_inputs.h"
#include "app/gonio/acquisition/photograph_result.h"
#include "app/gonio/document/background_task.h"

namespace gonio::app {

/// A material from photographs, without widgets: reads images, holds their outlines and lights, and reconstructs the
/// material. Each step runs in the background. Inputs and result stay until they are replaced or removed.
class PhotographSession : public QObject {
  Q_OBJECT

 public:
  enum class Step { idle, reading, learning, reconstructing };

  /// @param tasks may be destroyed before the session. @param training returns the materials to learn from, with their
  /// basis if it is already learned.
  PhotographSession(BackgroundTasks& tasks, std::function<PhotographTraining()> training, QObject* parent = nullptr);

  /// Reads files: images are added to the photographs, a description replaces them.
  void open(const QStringList& paths);
  const PhotographInputs& inputs() const { return m_inputs; }
  void remove(std::size_t index);
  void setDisc(std::size_t index, const matching::Disc& disc);
  void setCamera(std::size_t index, const PhotographCamera& camera);
  /// An environment file is read first, so that an error shows at once.
  void setLight(std::size_t index, const PhotographLight& light);
  /// Gives all photographs the lights of this one.
  void useLightForAll(std::size_t index);
  void setExposureKnown(bool known);
  /// Finds the outline of the sphere in the image again.
  void findOutline(std::size_t index);
  /// Writes the description; files in its folder have relative paths.
  void saveDescription(const QString& path);

  void reconstruct();
  /// Stops the current step; inputs and result stay.
  void cancel();
  Step step() const { return m_step; }
  bool isBusy() const { return m_step != Step::idle; }
  /// Progress of the current step, [0, 1].
  double fraction() const;
  /// Null until there is a result.
  const PhotographResultPtr& result() const { return m_result; }
  /// Whether the result is that of the inputs and the training set.
  bool isResultCurrent() const { return m_result && m_resultRevision == m_revision && isLearned(m_training()); }
  /// The place in the result of a photograph; nullopt if it was not part of it.
  std::optional<std::size_t> placeInResult(std::size_t index) const;
  /// Name of the result as a material: "front from 3 photographs".
  QString resultName() const;

  /// The bundled environment of the second picture of the result.
  void setOtherLight(const QString& environment);
  const QString& otherLight() const { return m_otherLight; }
  /// The result in this light; null until it is rendered.
  const QImage& otherSphere() const { return m_otherSphere; }

  /// Sets the effort of later reconstructions.
  void setQuality(std::size_t maxRegions, const rendering::RenderOptions& picture);

 Q_SIGNALS:
  /// Photographs were added, removed or changed.
  void inputsChanged();
  void resultChanged();
  void otherSphereChanged();
  /// The step or its progress changed.
  void progressed();
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);

 private:
  void setStep(Step step);
  void changed();
  void install(PhotographInputs inputs);
  void changeLight(std::size_t index, const PhotographLight& light);
  bool isLearned(const PhotographTraining& training) const;
  void learn(const PhotographTraining& training);
  void fit();
  void renderOther();
  std::function<void(const QString&)> failure(const QString& title);

  BackgroundTasks& m_tasks;
  std::function<PhotographTraining()> m_training;
  PhotographInputs m_inputs;
  PhotographTraining m_learned;  ///< with basis and prior; without ids before anything was learned
  PhotographResultPtr m_result;
  int m_revision = 0, m_resultRevision = -1;  ///< of the inputs, and of those of the result
  QString m_otherLight = QStringLiteral("sunset");
  QImage m_otherSphere;
  Step m_step = Step::idle;
  std::size_t m_maxRegions = photograph::defaultRegions;
  rendering::RenderOptions m_picture;
};

}  // namespace gonio::app
