// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <array>

#include "core/math/types.h"
#include "core/models/parameter_spec.h"

class QComboBox;
class QToolButton;

namespace gonio::widgets {

/// The single value of three linked channels: their luminance if none can be negative, else their mean.
double linkedValue(const models::ParameterSpec& spec, const Rgb& channels);

/// The channels after moving the linked value to `target`: scaled by one factor, which preserves the tint (or shifted,
/// if a channel can be negative or all are 0), within the hard range.
Rgb withLinkedValue(const models::ParameterSpec& spec, const Rgb& channels, double target);

/// Whether a parameter is a colour that a swatch can show.
bool isColour(const models::ParameterSpec& spec);

class ColourSwatch;
class ParameterLine;

/// One parameter as its spec describes it: a number, a choice, or three channels linked by one slider, with a swatch
/// for colours and a disclosure that shows one line per channel.
class ParameterRow : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterRow(const models::ParameterSpec& spec, QWidget* parent = nullptr);

  void setValue(const Rgb& value, const Rgb& reference);
  const models::ParameterSpec& spec() const { return *m_spec; }
  bool isModified() const { return m_value != m_reference; }
  /// Disables the row while the parameter has no effect; tooltips then start with `reason`.
  void setActive(bool active, const QString& reason);
  /// Updates the display after a change of the program's units.
  void showUnits();

 Q_SIGNALS:
  void editingStarted();
  void valueEdited(const gonio::Rgb& value);
  void editingFinished();
  void resetRequested();

 private:
  void buildNumber();
  void buildChannels();
  void buildChoice();
  void connectLine(ParameterLine* line);
  void offer(const Rgb& value);
  void refresh();
  void describe();
  void setChannelsShown(bool shown);

  const models::ParameterSpec* m_spec;
  Rgb m_value{0}, m_reference{0};
  QString m_inactiveReason;
  ParameterLine* m_line = nullptr;
  std::array<ParameterLine*, 3> m_channels{};
  QToolButton* m_disclosure = nullptr;
  ColourSwatch* m_swatch = nullptr;
  QComboBox* m_choice = nullptr;
};

}  // namespace gonio::widgets
