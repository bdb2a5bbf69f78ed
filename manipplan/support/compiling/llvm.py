"""Machine code from LLVM's intermediate language, by the LLVM of llvmlite, where there is no C compiler."""

from typing import Any

#: Level of optimisation.
LEVEL = 3


def compiled_by_llvm(text: str) -> Any:
    """An execution engine with the functions of a module in LLVM's language, for the processor of this machine.

    Addresses are given by `get_function_address(name)`; the code lives as long as the engine. Raises RuntimeError when LLVM
    does not accept the module.
    """
    from llvmlite import binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_default_triple()
    features = llvm.get_host_cpu_features().flatten()
    machine = target.create_target_machine(cpu=llvm.get_host_cpu_name(), features=features, opt=LEVEL, jit=True)
    module = llvm.parse_assembly(text)
    module.triple, module.data_layout = target.triple, str(machine.target_data)
    module.verify()
    options = llvm.create_pipeline_tuning_options(speed_level=LEVEL)
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    engine = llvm.create_mcjit_compiler(module, machine)
    engine.finalize_object()
    return engine
