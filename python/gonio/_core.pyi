# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# The extension is private: the modules beside it have the types.
from typing import Any

version: str

class Error(ValueError): ...

def __getattr__(name: str) -> Any: ...
