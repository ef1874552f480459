"""Digest of all that a Python function depends on, the same in another process: code, what it holds, what it names.

A function is its byte code and the source of its module; its defaults; the cells that it closes over, by value; the
globals that its code names, and those of the functions among them. A method and a callable object are their class and
their state; ``functools.partial`` and other objects of installed packages what they would be pickled as; an array its
content. Of installed packages, Python's own included, the version counts. What has no such content (a lock, an open
file, a generator) or looks names up at run time (``eval``) makes a function that cannot be identified.

Not seen: files that it reads, the clock, the environment.
"""

from __future__ import annotations

import copyreg
import dis
import hashlib
import importlib
import inspect
import sys
import sysconfig
import types
import warnings
from collections.abc import Callable, Iterable, Iterator
from functools import cache, cached_property, partial, singledispatchmethod
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

__all__ = ["UnidentifiedError", "code_digest"]

MOST_PARTS, MOST_BYTES = 1_000_000, 1 << 30
"""Objects, and bytes of arrays and texts, beyond which a function holds too much."""

_AT_RUN_TIME = ("eval", "exec", "globals", "locals", "__import__")
_PLAIN = (type(None), bool, int, float, complex, str, type(...), type(NotImplemented))
_OF_EVERY_CLASS = ("__dict__", "__weakref__", "__doc__", "__module__", "__annotations__", "__slotnames__", "_abc_impl")


class UnidentifiedError(Exception):
    """Something of which nobody can say whether it is the same another time."""


def code_digest(function: Callable[..., Any]) -> str:
    """Digest of a function, a method or a callable object; raises :class:`UnidentifiedError`, with what prevents it."""
    found = _Digest()
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of attributes that are only looked at
            found.add(function)
    except UnidentifiedError:
        raise
    except RecursionError:
        raise UnidentifiedError("it holds objects within objects without end") from None
    except Exception as error:  # whatever a user's objects do when they are asked what they hold
        raise UnidentifiedError(f"it holds an object that cannot be read ({type(error).__name__})") from error
    return found.whole.hexdigest()


class _Digest:
    """A digest that grows by objects; one that was seen before counts by its number."""

    def __init__(self) -> None:
        self.whole = hashlib.sha256()
        self._seen: dict[int, tuple[int, Any]] = {}
        self._parts = self._bytes = 0

    def put(self, *words: object) -> None:
        """Take in words or bytes, each with its length."""
        for word in words:
            content = word if isinstance(word, bytes | memoryview) else str(word).encode("utf-8", "surrogatepass")
            self._bytes += len(content)
            self.whole.update(f"{len(content)} ".encode())
            self.whole.update(content)
        self._parts += 1
        if self._parts > MOST_PARTS or self._bytes > MOST_BYTES:
            raise UnidentifiedError(f"it holds more than {MOST_PARTS:,} objects or {MOST_BYTES / 1e9:.2g} GB")

    def add(self, value: Any) -> None:
        """Take in an object with all that it holds."""
        if type(value) in _PLAIN:
            self.put(type(value).__name__, repr(value))
            return
        if not isinstance(value, tuple | frozenset | bytes | types.CodeType):  # equal ones may be one, or several
            if id(value) in self._seen:
                self.put("seen", self._seen[id(value)][0])
                return
            self._seen[id(value)] = len(self._seen), value
        self.put(type(value).__name__)
        vars(_Digest)["_content"].dispatcher.dispatch(type(value))(self, value)  # not by what it claims to be

    def all(self, values: Iterable[Any]) -> None:
        """Take in several, in their order."""
        for value in values:
            self.add(value)
        self.put("end")

    def _unordered(self, values: Iterable[Any]) -> None:
        digests: list[str] = []
        for value in values:
            (one := _Digest()).add(value)
            digests.append(one.whole.hexdigest())
        self.put(*sorted(digests), "end")

    @singledispatchmethod
    def _content(self, value: Any) -> None:
        """An object of a user's class by this and its state; another, and what its bases add, by what is pickled."""
        cls = type(value)
        if not _of_package(cls):
            self.add(cls)
            self.all([*vars(value).items()] if hasattr(value, "__dict__") else ())
            self.all((name, getattr(value, name, None)) for name in _slots(cls))
            if base := next((one for one in _VALUES if isinstance(value, one)), None):
                self.add(base(value) if base is not np.ndarray else np.array(value))
            elif all(one is object or not _of_package(one) or one.__module__ == "abc" for one in cls.__mro__):
                return
        self._reduced(value, copyreg.dispatch_table.get(cls))

    def _reduced(self, value: Any, reduce: Callable[[Any], Any] | None) -> None:
        """What an object would be pickled as."""
        cls = type(value)
        try:
            found = reduce(value) if reduce else value.__reduce_ex__(4)
        except TypeError:
            raise UnidentifiedError(f"it holds a `{cls.__qualname__}`, which has no content to compare") from None
        self.put(_version(cls.__module__))
        if isinstance(found, str):
            self.put(cls.__module__, getattr(value, "__module__", ""), found)
            self.add(getattr(value, "__wrapped__", None))
            return
        for part in found:
            self.all(part) if isinstance(part, Iterator) else self.add(part)

    @_content.register(bytes)
    @_content.register(bytearray)
    @_content.register(memoryview)
    def _(self, value: Any) -> None:
        self.put(bytes(value))

    @_content.register(tuple)
    @_content.register(list)
    def _(self, value: Any) -> None:
        if type(value) in (tuple, list):
            self.all(value)
        else:
            self.add(type(value))
            self.all([*value, *getattr(value, "__dict__", {}).items()])

    @_content.register(dict)
    @_content.register(types.MappingProxyType)
    def _(self, value: Any) -> None:
        if type(value) not in (dict, types.MappingProxyType):
            self.add(type(value))
            self.all(getattr(value, "__dict__", {}).items())
        self.all(value.items())

    @_content.register(set)
    @_content.register(frozenset)
    def _(self, value: Any) -> None:
        self._unordered(value)

    @_content.register(np.ndarray)
    def _(self, value: Any) -> None:
        self.put(value.dtype.str, repr(value.dtype), value.shape)
        if value.dtype.hasobject:
            self.all(value.ravel().tolist())
        else:
            self.put(np.ascontiguousarray(value).reshape(-1).view(np.uint8).data if value.size else b"")

    @_content.register(types.CodeType)
    def _(self, value: Any) -> None:
        self.put(value.co_code, value.co_names, value.co_freevars, value.co_cellvars, value.co_exceptiontable)
        self.put(value.co_argcount, value.co_posonlyargcount, value.co_kwonlyargcount, value.co_flags)
        self.all(value.co_consts)

    @_content.register(types.FunctionType)
    def _(self, value: Any) -> None:
        self.put(value.__qualname__)
        self._module(value.__module__)
        if _installed(value.__module__) and "<locals>" not in value.__qualname__:
            return
        self.add(value.__code__)
        self.all([value.__defaults__, value.__kwdefaults__, *value.__dict__.items()])
        self._named(value.__code__, [*_contents(value.__closure__ or ())], value.__globals__, value.__module__)

    def _named(self, code: types.CodeType, cells: Iterable[Any], known: dict[str, Any], module: str) -> None:
        """What code names outside of itself: cells, globals, and in modules of the user what it may ask them for."""
        codes = [*_codes(code)]
        names = dict.fromkeys(name for one in codes for name in _globals_of(one))
        attributes = dict.fromkeys(name for one in codes for name in one.co_names)
        for value in cells:
            self._global(value, attributes)
        if _installed(module):
            return
        if found := [name for name in _AT_RUN_TIME if name in names and name not in known]:
            raise UnidentifiedError(f"it calls `{found[0]}`, which looks up names at run time")
        for name in names:
            if name in known:
                self.put(name)
                self._global(known[name], attributes)
        for name in dict.fromkeys(each for one in codes for each in _imports_of(one)):
            self.put(name)
            self._global(_imported(name), attributes)

    def _global(self, value: Any, attributes: Iterable[str], depth: int = 0) -> None:
        """A value that code names; of a module, what it may ask it for."""
        if not isinstance(value, types.ModuleType):
            self.add(value)
            return
        self._module(value.__name__)
        if _installed(value.__name__) or depth > _DEEPEST_MODULE:
            return
        for name in attributes:
            if name in vars(value):
                self.put(name)
                self._global(vars(value)[name], attributes, depth + 1)

    def _module(self, name: str) -> None:
        """A module by its name; of a user's with its source, of an installed one with its version."""
        self.put("__main__" if name == "__mp_main__" else name)  # as a process that was started calls it
        self.put(_version(name) if _installed(name) else _source(name))

    @_content.register(types.ModuleType)
    def _(self, value: Any) -> None:
        self._module(value.__name__)

    @_content.register(types.MethodType)
    def _(self, value: Any) -> None:
        self.all([value.__func__, value.__self__])

    @_content.register(types.BuiltinFunctionType)
    @_content.register(types.MethodWrapperType)
    def _(self, value: Any) -> None:
        self.put(value.__qualname__)
        self._global(value.__self__, ())

    @_content.register(types.WrapperDescriptorType)
    @_content.register(types.MethodDescriptorType)
    @_content.register(types.ClassMethodDescriptorType)
    @_content.register(types.GetSetDescriptorType)
    @_content.register(types.MemberDescriptorType)
    def _(self, value: Any) -> None:
        self.put(value.__objclass__.__qualname__, value.__name__)

    @_content.register(np.ufunc)
    def _(self, value: Any) -> None:
        self.put(value.__name__, np.__version__)

    @_content.register(partial)
    def _(self, value: Any) -> None:
        self.add(type(value))
        self.all([value.func, value.args, value.keywords, *vars(value).items()])

    @_content.register(staticmethod)
    @_content.register(classmethod)
    def _(self, value: Any) -> None:
        self.add(value.__func__)

    @_content.register(property)
    def _(self, value: Any) -> None:
        self.all([value.fget, value.fset, value.fdel])

    @_content.register(cached_property)
    def _(self, value: Any) -> None:
        self.add(value.func)

    @_content.register(type)
    def _(self, value: Any) -> None:
        self.put(value.__qualname__)
        self._module(value.__module__)
        if not _of_package(value):
            kept = [item for item in vars(value).items() if not item[0].startswith("__pydantic")]
            self.all([*value.__bases__, *(item for item in kept if item[0] not in _OF_EVERY_CLASS)])


_DEEPEST_MODULE = 5
_VALUES: tuple[type[Any], ...] = (int, float, complex, str, bytes, np.ndarray, set, frozenset)


def _contents(cells: Iterable[Any]) -> Iterator[Any]:
    for cell in cells:
        try:
            yield cell.cell_contents
        except ValueError:  # not filled yet
            yield None


def _slots(cls: type[Any]) -> Iterator[str]:
    for one in cls.__mro__:
        yield from (name for name, member in vars(one).items() if isinstance(member, types.MemberDescriptorType))


def _codes(code: types.CodeType) -> Iterator[types.CodeType]:
    """Code, and that of functions within it."""
    yield code
    for one in code.co_consts:
        if isinstance(one, types.CodeType):
            yield from _codes(one)


def _globals_of(code: types.CodeType) -> Iterator[str]:
    return (one.argval for one in dis.get_instructions(code) if one.opname in ("LOAD_GLOBAL", "LOAD_NAME"))


def _imports_of(code: types.CodeType) -> Iterator[str]:
    return (one.argval for one in dis.get_instructions(code) if one.opname == "IMPORT_NAME")


def _imported(name: str) -> Any:
    """A user's module that code imports when it is called; the name of an installed one, or of none."""
    try:
        own = bool(name) and not _installed(name) and find_spec(name.partition(".")[0]) is not None
        return importlib.import_module(name) if own else name
    except Exception:  # it will say so where it is called
        return name


@cache
def _installed(module: str) -> bool:
    """Whether a module is one of Python, of tmodes, or of an installed package, which its version identifies."""
    top = module.partition(".")[0]
    if top in sys.stdlib_module_names and top not in ("__main__", "__mp_main__"):
        return True
    found = sys.modules.get(module)
    file = getattr(found, "__file__", None) if found else getattr(_spec(top), "origin", None)
    return (file is not None and Path(file).is_relative_to(_HOME)) or str(file).startswith(_PACKAGES)


_HOME = Path(__file__).parents[1]
_PACKAGES = tuple({f"{sysconfig.get_path(name)}/" for name in ("purelib", "platlib", "stdlib", "platstdlib")})


def _of_package(cls: type[Any]) -> bool:
    """Whether a class is one of an installed package, or is made by compiled code, which alone has this flag."""
    return _installed(cls.__module__) or bool(cls.__flags__ & _IMMUTABLE)


_IMMUTABLE = 1 << 8


def _spec(name: str) -> Any:
    try:
        return find_spec(name)
    except (ImportError, ValueError):
        return None


def _version(module: str) -> str:
    """Version of the package of a module; of Python for its own."""
    top = module.partition(".")[0]
    return sys.version if top in sys.stdlib_module_names else str(getattr(sys.modules.get(top), "__version__", ""))


def _source(module: str) -> str:
    try:
        return inspect.getsource(sys.modules[module])
    except (OSError, TypeError, KeyError):
        return ""
