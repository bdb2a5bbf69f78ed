"""Machine code from LLVM's language, by the LLVM of llvmlite, kept in the user's cache folder."""

import hashlib
import logging
from collections.abc import Callable
from typing import Any

from manipplan.support.compiling.compiler import log_when_slow
from manipplan.support.compiling.stored import cache_errors, cache_for, is_sound, place_to_build, publish
from manipplan.support.errors import CompilerError

log = logging.getLogger("manipplan")
#: Level of optimisation.
LEVEL = 3


def compile_by_llvm(text: str, subject: str) -> Any:
    """An execution engine with the functions of a module in LLVM's language, for the processor of this machine.

    Addresses are given by `get_function_address(name)`; the code lives as long as the engine.

    Args:
        text: the module, which needs no optimisation before it becomes machine code.
        subject: what it is, for messages.

    Raises:
        CompilerError: LLVM does not accept the module.
    """
    import llvmlite
    from llvmlite import binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_default_triple()
    cpu, features = llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()
    machine = target.create_target_machine(cpu=cpu, features=features, opt=LEVEL, jit=True)
    key = "\0".join([text, llvmlite.__version__, target.triple, cpu, features, str(LEVEL)])
    with log_when_slow(f"compiling {subject}, by LLVM"):
        code = _stored(key, subject, lambda: _machine_code(text, subject, machine, target.triple))
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    return engine


def _machine_code(text: str, subject: str, machine: Any, triple: str) -> bytes:
    """An object file."""
    from llvmlite import binding as llvm

    try:
        module = llvm.parse_assembly(text)
        module.triple, module.data_layout = triple, str(machine.target_data)
        module.verify()
    except RuntimeError as error:
        raise CompilerError(subject, str(error)) from error
    return bytes(machine.emit_object(module))


def _stored(key: str, subject: str, compile_now: Callable[[], bytes]) -> bytes:
    """The machine code of that key from the cache, or made now and put there."""
    file = None
    try:
        file = cache_for(subject) / f"{hashlib.sha256(key.encode()).hexdigest()[:32]}.o"
        if is_sound(file):
            return file.read_bytes()
    except CompilerError as error:
        log.info("%s: compiled by LLVM in each process: %s", subject, error)
    code = compile_now()
    if file is not None:
        try:
            with place_to_build(file.parent, subject) as place, cache_errors(file.parent, subject):
                (place / file.name).write_bytes(code)
                publish(place / file.name, file)
        except CompilerError as error:
            log.info("%s: compiled by LLVM in each process: %s", subject, error)
    return code
