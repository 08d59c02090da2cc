// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/edit_arguments.h"

#include <QLocale>

#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

QString valueText(const models::ParameterSpec& spec, const Rgb& value) {
  if (!spec.choices.empty()) return widgets::displayValue(spec, value);
  const auto number = [](double x) { return QString::number(x, 'g', QLocale::FloatingPointShortest); };
  return spec.perChannel ? QStringList{number(value.x), number(value.y), number(value.z)}.join(',') : number(value.x);
}

QStringList assignments(const QString& option, const models::ModelSpec& spec, const models::ParameterValues& values,
                        const models::ParameterValues& unchanged) {
  QStringList result;
  for (std::size_t i = 0; i < spec.parameters.size(); ++i)
    if (values.values[i] != unchanged.values[i])
      result << QStringLiteral("%1 %2=%3")
                    .arg(option, widgets::toQString(spec.parameters[i].id),
                         valueText(spec.parameters[i], values.values[i]));
  return result;
}

}  // namespace

QString editArguments(const editing::DifferentialEdit& edit) {
  const models::ModelSpec &spec = edit.model->spec(), &controls = editing::artistControls();
  QStringList arguments{QStringLiteral("--model ") + widgets::toQString(spec.id)};
  arguments << assignments(QStringLiteral("--set"), spec, edit.edited, edit.fitted)
            << assignments(QStringLiteral("--control"), controls, edit.controls, models::defaultParameters(controls))
            << QStringLiteral("--compose ") +
                   widgets::toQString(editing::compositionIds[std::size_t(edit.composition)]);
  return arguments.join(' ');
}

}  // namespace gonio::app
