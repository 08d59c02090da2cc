// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <array>

#include "app/gonio/acquisition/photograph_session.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace gonio::widgets {
class NumberField;
}

namespace gonio::app {

/// The inputs of a material from photographs: the outline, camera and light of the current photograph, and the exposure
/// of all.
class PhotographControls : public QWidget {
  Q_OBJECT

 public:
  explicit PhotographControls(PhotographSession& session);

  /// Shows a photograph; -1: none.
  void setCurrent(int index);
  void refresh();

 Q_SIGNALS:
  void openRequested();
  void saveRequested();

 private:
  void buildFiles(QFormLayout& form);
  void buildOutline(QFormLayout& form);
  void buildCamera(QFormLayout& form);
  void buildLight(QFormLayout& form);
  void buildExposure(QFormLayout& form);
  void connectFields();
  void showItem(const PhotographItem& item);
  void showLight(const PhotographItem& item);
  void showEnvironment(const QString& name);
  void editDisc();
  void editCamera();
  void editLight();
  void chooseEnvironment(int index);
  void askForEnvironment();

  PhotographSession& m_session;
  int m_current = -1;
  QFormLayout* m_form;
  QPushButton *m_remove, *m_save, *m_find, *m_useForAll;
  QLabel *m_name, *m_rotationLabel;
  widgets::NumberField *m_x, *m_y, *m_radius, *m_distance, *m_azimuth, *m_elevation;
  QComboBox *m_kind, *m_environment, *m_exposure;
  widgets::NumberField *m_rotation, *m_lightAzimuth, *m_lightElevation, *m_irradiance;
  QWidget* m_lightDirection;
  std::vector<QWidget*> m_ofItem;  ///< enabled if there is a photograph
};

}  // namespace gonio::app
