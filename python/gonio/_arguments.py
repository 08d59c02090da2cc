# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Checks of arguments that all public functions share."""
from __future__ import annotations

import functools
import inspect
import math
import os
from typing import Any, Callable, Mapping, Union

import numpy as np

from . import _core

PathLike = Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]


def check_finite(name: str, value: Any) -> None:
    """Raises Error that states the name if a number, or one in a list, dict or array, is NaN or infinite."""
    if isinstance(value, np.ndarray):
        found = value[~np.isfinite(value)] if value.dtype.kind == "f" else ()
        if len(found) > 0:
            raise _core.Error(f"{name}: found {found.flat[0]}, expected finite numbers")
    elif isinstance(value, Mapping):
        for key, item in value.items():
            check_finite(str(key), item)
    elif isinstance(value, (list, tuple)):
        for item in value:
            check_finite(name, item)
    elif hasattr(value, "__float__") and not isinstance(value, int) and not math.isfinite(value):
        raise _core.Error(f"{name}: found {value}, expected a finite number")


def _check_text(name: str, text: str) -> None:
    if not text.isascii() and any("\ud800" <= character <= "\udfff" for character in text):
        raise _core.Error(f"{name}: found {text!r}, expected text without surrogates")


def _check_path(name: str, path: Any) -> None:
    if b"\0" in os.fsencode(path):  # would end the name there
        raise _core.Error(f"{name}: found {os.fspath(path)!r}, embedded null byte")


def _check(name: str, value: Any, may_be_path: bool) -> None:
    check_finite(name, value)
    for one in value if isinstance(value, (list, tuple)) else (value,):
        if may_be_path and isinstance(one, (str, bytes, os.PathLike)):
            _check_path(name, one)
        elif isinstance(one, str):
            _check_text(name, one)


def checked(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function with checks of its numbers, texts and file names. Arrays, which may be large, have checks of their own."""
    signature = inspect.signature(function)
    types = {name: str(parameter.annotation) for name, parameter in signature.parameters.items()
             if name != "self" and parameter.annotation not in ("ArrayLike", "Optional[ArrayLike]", "Progress")}
    if not types:
        return function

    @functools.wraps(function)
    def call(*arguments: Any, **keywords: Any) -> Any:
        try:
            given = signature.bind(*arguments, **keywords).arguments
        except TypeError:
            return function(*arguments, **keywords)  # whose own message names it
        for name, value in given.items():
            if name in types:
                _check(name, value, "PathLike" in types[name])
        return function(*arguments, **keywords)

    return call
