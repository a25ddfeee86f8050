"""The tables of grammars/mint.lark; written by `python -m motionlang.lang.grammar`, not by hand."""

# ruff: noqa
# mypy: ignore-errors
# fmt: off

from motionlang.lang.tables import Tables, new
from motionlang.mint.build import *
from motionlang.mint.nodes import *


def _none_0(V, T):
    V.append([])


def _module_1(V, T):
    v0 = V[-1]
    V[-1] = module(v0)


def _auto_2(V, T):
    v0 = V[-1]
    V[-1] = n = new(Auto)
    n.at = v0


def _name_3(V, T):
    v0 = V[-1]
    V[-1] = n = new(Name)
    n.at = v0
    n.name = T[v0]
    n.args = None
    n.axes = False


def _skip_4(V, T):
    V.pop()


def _dotted_5(V, T):
    v0 = V[-1]
    V[-1] = dotted(v0, T[v0])


def _end_6(V, T):
    v0 = V[-1]
    V[-1] = n = new(End)
    n.at = v0
    n.name = None if None is None else T[None]


def _exit_7(V, T):
    v0 = V[-1]
    V[-1] = n = new(Exit)
    n.at = v0
    n.kind = '' if None is None else T[None].lower()


def _return_8(V, T):
    v0 = V[-1]
    V[-1] = n = new(Return)
    n.at = v0


def _label_before_9(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = label_before(v0, v1, T)


def _call_10(V, T):
    v0 = V[-1]
    V[-1] = n = new(Call)
    n.at = v0.at
    n.target = v0


def _body_11(V, T):
    V.append(body(V))


def _one_12(V, T):
    v0 = V[-1]
    V[-1] = [v0]


def _const_13(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = constants(v0, v1)


def _plain_one_14(V, T):
    v0 = V[-1]
    V[-1] = [declare(v0)]


def _dim_15(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Dim)
    n.at = v0
    n.variables = v1
    n.nv = None is not None


def _end_16(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(End)
    n.at = v0
    n.name = None if v1 is None else T[v1]


def _exit_17(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Exit)
    n.at = v0
    n.kind = '' if v1 is None else T[v1].lower()


def _gosub_18(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Jump)
    n.at = v0
    n.kind = 'gosub'
    n.name = T[v1]
    n.unless = None


def _goto_19(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Jump)
    n.at = v0
    n.kind = 'goto'
    n.name = T[v1]
    n.unless = None


def _label_20(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Label)
    n.at = v0
    n.name = T[v1]


def _character_21(V, T):
    v0 = V[-1]
    V[-1] = n = new(Number)
    n.at = v0
    n.value = ord(string(T[v0]))


def _number_22(V, T):
    v0 = V[-1]
    V[-1] = n = new(Number)
    n.at = v0
    n.value = NUMBERS[T[v0]]


def _string_23(V, T):
    v0 = V[-1]
    V[-1] = n = new(String)
    n.at = v0
    n.value = string(T[v0])


def _input_24(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Input)
    n.at = v0
    n.target = v1
    n.prompt = None if None is None else String(None, string(T[None]))
    n.using = None or []
    n.terminal = None


def _bare_call_25(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Call)
    n.at = v0
    n.target = Name(v0, T[v0], v1)


def _pause_26(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Pause)
    n.at = v0
    n.condition = v1


def _print_27(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Print)
    n.at = v0
    n.items = v1 if None is None else [*v1, None]
    n.terminal = None


def _run_28(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Run)
    n.at = v0
    n.name = T[v1]


def _more_29(V, T):
    V.pop()
    v1 = V.pop()
    V[-1].append(v1)


def _name_empty_30(V, T):
    V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(Name)
    n.at = v0
    n.name = T[v0]
    n.args = []
    n.axes = False


def _dim_31(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Dim)
    n.at = v0
    n.variables = v2
    n.nv = v1 is not None


def _gosub_32(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(Jump)
    n.at = v0
    n.kind = 'gosub'
    n.name = T[v2]
    n.unless = None


def _goto_33(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(Jump)
    n.at = v0
    n.kind = 'goto'
    n.name = T[v2]
    n.unless = None


def _complement_34(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Unary)
    n.at = v0
    n.op = '~'
    n.operand = v1


def _minus_35(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Unary)
    n.at = v0
    n.op = '-'
    n.operand = v1


def _not_36(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Unary)
    n.at = v0
    n.op = 'Not'
    n.operand = v1


def _plus_37(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Unary)
    n.at = v0
    n.op = '+'
    n.operand = v1


def _last_item_38(V, T):
    v0 = V[-1]
    V[-1] = n = new(PrintItem)
    n.at = v0.at
    n.value = v0
    n.using = []
    n.separator = ''


def _print_39(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Print)
    n.at = v0
    n.items = v1 if v2 is None else [*v1, v2]
    n.terminal = None


def _none_40(V, T):
    V[-1] = []


def _for_41(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = counted(v0, v1, None, T)


def _for_shared_42(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = counted(v0, v1, v2, T)


def _member_43(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(Member)
    n.at = v0.at
    n.value = v0
    n.field = T[v2]
    n.args = None


def _next_case_44(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = next_case(v0, v1, v2)


def _one_omitted_45(V, T):
    v0 = V[-1]
    V[-1] = [Omitted(v0)]


def _assign_one_46(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(Assign)
    n.at = v0.at
    n.target = v0
    n.values = [v2]
    n.repeat = False


def _assign_47(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(Assign)
    n.at = v0.at
    n.target = v0
    n.values = v2
    n.repeat = None is not None


def _name_arg_48(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = n = new(Name)
    n.at = v0
    n.name = T[v0]
    n.args = [v2]
    n.axes = False


def _name_args_49(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = n = new(Name)
    n.at = v0
    n.name = T[v0]
    n.args = v2
    n.axes = False


def _name_axes_50(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = n = new(Name)
    n.at = v0
    n.name = T[v0]
    n.args = v2
    n.axes = True


def _type_51(V, T):
    v0 = V[-1]
    V[-1] = n = new(TypeName)
    n.at = v0
    n.name = T[v0]
    n.size = None


def _constant_52(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Const(v0, T[v0], None, v2)


def _more_53(V, T):
    v2 = V.pop()
    V.pop()
    V[-1].append(v2)


def _define_54(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = n = new(Define)
    n.at = v0
    n.name = T[v1]
    n.value = v3


def _plain_more_55(V, T):
    v2 = V.pop()
    V.pop()
    V[-1].append(declare(v2))


def _variable_56(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = declare(v0, v2)


def _valued_variable_57(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = declare(v0, None, v2)


def _more_values_58(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = more_values(v0, v2)


def _parameter_59(V, T):
    v0 = V[-1]
    V[-1] = n = new(Parameter)
    n.at = v0
    n.name = T[v0]
    n.type = None
    n.by_ref = False
    n.is_array = None is not None


def _none_60(V, T):
    V.pop()
    V[-1] = []


def _inner_61(V, T):
    V.pop()
    v1 = V.pop()
    V[-1] = v1


def _and_62(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(Binary)
    n.at = v0.at
    n.op = 'And'
    n.left = v0
    n.right = v2


def _binary_63(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Binary)
    n.at = v0.at
    n.op = T[v1]
    n.left = v0
    n.right = v2


def _line_if_64(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = n = new(If)
    n.at = v0
    n.condition = v1
    n.body = v3
    n.orelse = []


def _or_65(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(Binary)
    n.at = v0.at
    n.op = 'Or'
    n.left = v0
    n.right = v2


def _xor_66(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(Binary)
    n.at = v0.at
    n.op = 'Xor'
    n.left = v0
    n.right = v2


def _mod_67(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(Binary)
    n.at = v0.at
    n.op = 'Mod'
    n.left = v0
    n.right = v2


def _input_68(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = n = new(Input)
    n.at = v0
    n.target = v3
    n.prompt = None if v1 is None else String(v1, string(T[v1]))
    n.using = None or []
    n.terminal = None


def _input_69(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = n = new(Input)
    n.at = v0
    n.target = v1
    n.prompt = None if None is None else String(None, string(T[None]))
    n.using = v3 or []
    n.terminal = None


def _loop_70(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = n = new(Loop)
    n.at = v0
    n.body = v2


def _print_item_71(V, T):
    v2 = V.pop()
    v1 = V.pop()
    n = new(PrintItem)
    n.at = v1.at
    n.value = v1
    n.using = []
    n.separator = T[v2]
    V[-1].append(n)


def _for_72(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = counted(v0, v1, v3, T)


def _test_73(V, T):
    v0 = V[-1]
    V[-1] = n = new(CaseTest)
    n.at = v0.at
    n.op = '='
    n.value = v0
    n.high = None


def _last_case_74(V, T):
    v0 = V[-4]
    v1 = V[-3]
    del V[-3:]
    V[-1] = last_case(v0, v1)


def _one_75(V, T):
    V.pop()
    v0 = V[-1]
    V[-1] = [v0]


def _assign_same_76(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = n = new(Assign)
    n.at = v0.at
    n.target = v0
    n.values = [v2]
    n.repeat = True


def _next_omitted_77(V, T):
    v1 = V.pop()
    n = new(Omitted)
    n.at = v1
    V[-1].append(n)


def _last_78(V, T):
    v1 = V.pop()
    V[-1].append(v1)


def _assign_79(V, T):
    v0 = V[-4]
    v2 = V[-2]
    v3 = V[-1]
    del V[-3:]
    V[-1] = n = new(Assign)
    n.at = v0.at
    n.target = v0
    n.values = v2
    n.repeat = v3 is not None


def _pair_80(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = [v0, v2]


def _parameter_by_reference_81(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = None
    n.by_ref = True
    n.is_array = None is not None


def _parameter_by_value_82(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = None
    n.by_ref = False
    n.is_array = None is not None


def _if_do_83(V, T):
    v0 = V[-5]
    v1 = V[-4]
    v3 = V[-2]
    v4 = V[-1]
    del V[-4:]
    V[-1] = n = new(If)
    n.at = v0
    n.condition = v1
    n.body = v3
    n.orelse = v4


def _input_84(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = n = new(Input)
    n.at = v0
    n.target = v4
    n.prompt = None if None is None else String(None, string(T[None]))
    n.using = None or []
    n.terminal = v2


def _print_85(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = n = new(Print)
    n.at = v0
    n.items = v4 if None is None else [*v4, None]
    n.terminal = v2


def _last_using_86(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(PrintItem)
    n.at = v0.at
    n.value = v0
    n.using = v2
    n.separator = ''


def _repeat_87(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = n = new(Repeat)
    n.at = v0
    n.body = v2
    n.condition = v4


def _select_88(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = n = new(Select)
    n.at = v0
    n.subject = v2
    n.cases = [v4]


def _startup_89(V, T):
    v0 = V[-5]
    v2 = V[-3]
    del V[-4:]
    V[-1] = n = new(Startup)
    n.at = v0
    n.body = v2


def _while_90(V, T):
    v0 = V[-5]
    v1 = V[-4]
    v3 = V[-2]
    del V[-4:]
    V[-1] = n = new(While)
    n.at = v0
    n.condition = v1
    n.body = v3


def _case_else_91(V, T):
    V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(Case)
    n.at = v0
    n.tests = []
    n.body = []


def _case_92(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Case)
    n.at = v0
    n.tests = v1
    n.body = []


def _sized_type_93(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(TypeName)
    n.at = v0
    n.name = T[v0]
    n.size = v2


def _constant_94(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Const(v0, T[v0], v2, v4)


def _typed_variable_95(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = declare(v0, v2, v4)


def _event_96(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    del V[-5:]
    V[-1] = n = new(Event)
    n.at = v0
    n.name = T[v1]
    n.body = v3


def _parameter_97(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(Parameter)
    n.at = v0
    n.name = T[v0]
    n.type = v2
    n.by_ref = False
    n.is_array = None is not None


def _parameter_98(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(Parameter)
    n.at = v0
    n.name = T[v0]
    n.type = None
    n.by_ref = False
    n.is_array = v1 is not None


def _if_99(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v4 = V[-2]
    v5 = V[-1]
    del V[-5:]
    V[-1] = n = new(If)
    n.at = v0
    n.condition = v1
    n.body = v4
    n.orelse = v5


def _line_if_else_100(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    v5 = V[-1]
    del V[-5:]
    V[-1] = n = new(If)
    n.at = v0
    n.condition = v1
    n.body = v3
    n.orelse = v5


def _input_101(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    v5 = V[-1]
    del V[-5:]
    V[-1] = n = new(Input)
    n.at = v0
    n.target = v3
    n.prompt = None if v1 is None else String(v1, string(T[v1]))
    n.using = v5 or []
    n.terminal = None


def _print_102(V, T):
    v0 = V[-6]
    v2 = V[-4]
    v4 = V[-2]
    v5 = V[-1]
    del V[-5:]
    V[-1] = n = new(Print)
    n.at = v0
    n.items = v4 if v5 is None else [*v4, v5]
    n.terminal = v2


def _last_open_103(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = n = new(PrintItem)
    n.at = v0.at
    n.value = v0
    n.using = [v2]
    n.separator = ','


def _print_using_104(V, T):
    v1 = V[-4]
    v3 = V[-2]
    v4 = V[-1]
    del V[-4:]
    n = new(PrintItem)
    n.at = v1.at
    n.value = v1
    n.using = [v3]
    n.separator = T[v4]
    V[-1].append(n)


def _select_nothing_105(V, T):
    v0 = V[-6]
    v2 = V[-4]
    del V[-5:]
    V[-1] = n = new(Select)
    n.at = v0
    n.subject = v2
    n.cases = []


def _task_106(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    del V[-5:]
    V[-1] = task(v0, T[v1], v3)


def _user_type_107(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    del V[-5:]
    V[-1] = n = new(UserType)
    n.at = v0
    n.name = T[v1]
    n.members = v3


def _extend_108(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = extended(v0, v1)


def _shared_further_109(V, T):
    v1 = V[-4]
    v2 = V[-3]
    v3 = V[-2]
    del V[-4:]
    V[-1].append(counted(v1, v2, v3, T))


def _member_args_110(V, T):
    v0 = V[-6]
    v2 = V[-4]
    v4 = V[-2]
    del V[-5:]
    V[-1] = n = new(Member)
    n.at = v0.at
    n.value = v0
    n.field = T[v2]
    n.args = v4


def _test_is_111(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = n = new(CaseTest)
    n.at = v0
    n.op = T[v1]
    n.value = v2
    n.high = None


def _test_range_112(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = n = new(CaseTest)
    n.at = v0.at
    n.op = 'To'
    n.value = v0
    n.high = v2


def _for_head_113(V, T):
    v0 = V[-7]
    v1 = V[-6]
    v3 = V[-4]
    v5 = V[-2]
    del V[-6:]
    V[-1] = n = new(For)
    n.at = v0
    n.variable = Name(v1, T[v1])
    n.start = v3
    n.stop = v5
    n.step = None
    n.body = []


def _parameter_by_reference_114(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = v3
    n.by_ref = True
    n.is_array = None is not None


def _parameter_by_reference_115(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v2 = V[-2]
    del V[-3:]
    V[-1] = n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = None
    n.by_ref = True
    n.is_array = v2 is not None


def _parameter_by_value_116(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = v3
    n.by_ref = False
    n.is_array = None is not None


def _parameter_by_value_117(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v2 = V[-2]
    del V[-3:]
    V[-1] = n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = None
    n.by_ref = False
    n.is_array = v2 is not None


def _function_118(V, T):
    v0 = V[-7]
    v1 = V[-6]
    v2 = V[-5]
    v4 = V[-3]
    del V[-6:]
    V[-1] = n = new(Sub)
    n.at = v0
    n.name = T[v1]
    n.parameters = v2
    n.body = v4
    n.function = True
    n.result = None


def _input_119(V, T):
    v0 = V[-7]
    v2 = V[-5]
    v4 = V[-3]
    v6 = V[-1]
    del V[-6:]
    V[-1] = n = new(Input)
    n.at = v0
    n.target = v6
    n.prompt = None if v4 is None else String(v4, string(T[v4]))
    n.using = None or []
    n.terminal = v2


def _input_120(V, T):
    v0 = V[-7]
    v2 = V[-5]
    v4 = V[-3]
    v6 = V[-1]
    del V[-6:]
    V[-1] = n = new(Input)
    n.at = v0
    n.target = v4
    n.prompt = None if None is None else String(None, string(T[None]))
    n.using = v6 or []
    n.terminal = v2


def _sub_121(V, T):
    v0 = V[-7]
    v1 = V[-6]
    v2 = V[-5]
    v4 = V[-3]
    del V[-6:]
    V[-1] = n = new(Sub)
    n.at = v0
    n.name = T[v1]
    n.parameters = v2
    n.body = v4
    n.function = False
    n.result = None


def _extend_122(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = extended(v0, v2)


def _shared_123(V, T):
    v1 = V[-5]
    v2 = V[-4]
    v4 = V[-2]
    del V[-5:]
    V[-1].append(counted(v1, v2, v4, T))


def _parameter_124(V, T):
    v0 = V[-5]
    v1 = V[-4]
    v4 = V[-1]
    del V[-4:]
    V[-1] = n = new(Parameter)
    n.at = v0
    n.name = T[v0]
    n.type = v4
    n.by_ref = False
    n.is_array = v1 is not None


def _third_125(V, T):
    v2 = V[-2]
    del V[-3:]
    V[-1] = v2


def _print_using_two_126(V, T):
    v1 = V[-6]
    v3 = V[-4]
    v5 = V[-2]
    v6 = V[-1]
    del V[-6:]
    n = new(PrintItem)
    n.at = v1.at
    n.value = v1
    n.using = [v3, v5]
    n.separator = T[v6]
    V[-1].append(n)


def _for_head_127(V, T):
    v0 = V[-9]
    v1 = V[-8]
    v3 = V[-6]
    v5 = V[-4]
    v7 = V[-2]
    del V[-8:]
    V[-1] = n = new(For)
    n.at = v0
    n.variable = Name(v1, T[v1])
    n.start = v3
    n.stop = v5
    n.step = v7
    n.body = []


def _parameter_by_reference_128(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v2 = V[-4]
    v5 = V[-1]
    del V[-5:]
    V[-1] = n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = v5
    n.by_ref = True
    n.is_array = v2 is not None


def _parameter_by_value_129(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v2 = V[-4]
    v5 = V[-1]
    del V[-5:]
    V[-1] = n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = v5
    n.by_ref = False
    n.is_array = v2 is not None


def _function_130(V, T):
    v0 = V[-9]
    v1 = V[-8]
    v2 = V[-7]
    v4 = V[-5]
    v6 = V[-3]
    del V[-8:]
    V[-1] = n = new(Sub)
    n.at = v0
    n.name = T[v1]
    n.parameters = v2
    n.body = v6
    n.function = True
    n.result = v4


def _else_if_131(V, T):
    v0 = V[-5]
    v1 = V[-4]
    v3 = V[-2]
    v4 = V[-1]
    del V[-4:]
    V[-1] = [If(v0, v1, v3, v4)]


def _input_132(V, T):
    v0 = V[-9]
    v2 = V[-7]
    v4 = V[-5]
    v6 = V[-3]
    v8 = V[-1]
    del V[-8:]
    V[-1] = n = new(Input)
    n.at = v0
    n.target = v6
    n.prompt = None if v4 is None else String(v4, string(T[v4]))
    n.using = v8 or []
    n.terminal = v2


TOKEN = '[ \t]*+([A-Za-z_](?!(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM[A-Z][a-z]))[A-Za-z0-9_]*+(?!\\.[0-9])|[0-9.](?:(?<=[0-9])[0-9]*+\\.?[0-9]*+(?:[eE][+-]?[0-9]++)?+|(?<=\\.)[0-9]++(?:[eE][+-]?[0-9]++)?+|(?<=0)(?:[xX][0-9a-fA-F]++|[bB][01]++))(?![A-Za-z0-9_])|[\n\':Rr](?:(?<=\n)|(?<=\')[^\n]*+\n|(?:(?<=:)[ \t]*+[Rr])?+(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM(?=[A-Z][a-z]))[^\n]*+\n)[ \t]*+(?:(?:\'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)*+|"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"|[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++|`(?:[^`\\\\\n]|\\\\[^\n])`|<<|<=|<>|>=|>>|"[^\\n]*|[0-9][A-Za-z0-9_]*|.)'

CONTINUED = '(?:[ \t]++|[\\\\_][ \t]*+(?:\'[^\n]*+)?\n)*([A-Za-z_](?!(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM[A-Z][a-z]))[A-Za-z0-9_]*+(?!\\.[0-9])|[0-9.](?:(?<=[0-9])[0-9]*+\\.?[0-9]*+(?:[eE][+-]?[0-9]++)?+|(?<=\\.)[0-9]++(?:[eE][+-]?[0-9]++)?+|(?<=0)(?:[xX][0-9a-fA-F]++|[bB][01]++))(?![A-Za-z0-9_])|[\n\':Rr](?:(?<=\n)|(?<=\')[^\n]*+\n|(?:(?<=:)[ \t]*+[Rr])?+(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM(?=[A-Z][a-z]))[^\n]*+\n)[ \t]*+(?:(?:\'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)*+|"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"|[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++|`(?:[^`\\\\\n]|\\\\[^\n])`|<<|<=|<>|>=|>>|"[^\\n]*|[0-9][A-Za-z0-9_]*|.)'

LITERALS = {
    '!': 'COMPLEMENT',
    '#': 'HASH',
    '%': 'PERCENT',
    '&': 'AMPERSAND',
    '(': 'LPAR',
    ')': 'RPAR',
    '*': 'STAR',
    '+': 'PLUS',
    ',': 'COMMA',
    '-': 'MINUS',
    '.': 'DOT',
    '/': 'DIVIDE',
    ':': 'COLON',
    ';': 'SEMICOLON',
    '<': 'COMPARE',
    '<<': 'SHIFT',
    '<=': 'COMPARE',
    '<>': 'COMPARE',
    '=': 'EQUAL',
    '>': 'COMPARE',
    '>=': 'COMPARE',
    '>>': 'SHIFT',
    '?': 'QMARK',
    '[': 'LSQB',
    '\\': 'DIVIDE',
    ']': 'RSQB',
    '^': 'CIRCUMFLEX',
    'and': 'AND',
    'as': 'AS',
    'auto': 'AUTO',
    'byref': 'BYREF',
    'byval': 'BYVAL',
    'case': 'CASE',
    'const': 'CONST',
    'define': 'DEFINE',
    'dim': 'DIM',
    'do': 'DO',
    'else': 'ELSE',
    'elseif': 'ELSEIF',
    'end': 'END',
    'endif': 'ENDIF',
    'endl': 'ENDL',
    'endloop': 'ENDLOOP',
    'endw': 'ENDW',
    'endwhile': 'ENDWHILE',
    'event': 'EVENT',
    'exit': 'EXIT',
    'for': 'FOR',
    'function': 'FUNCTION',
    'gosub': 'GOSUB',
    'goto': 'GOTO',
    'if': 'IF',
    'input': 'INPUT',
    'is': 'IS',
    'loop': 'LOOP',
    'mod': 'MOD',
    'next': 'NEXT',
    'not': 'NOT',
    'nv': 'NV',
    'or': 'OR',
    'pause': 'PAUSE',
    'print': 'PRINT',
    'repeat': 'REPEAT',
    'return': 'RETURN',
    'run': 'RUN',
    'select': 'SELECT',
    'startup': 'STARTUP',
    'step': 'STEP',
    'sub': 'SUB',
    'task': 'TASK',
    'then': 'THEN',
    'to': 'TO',
    'type': 'TYPE',
    'until': 'UNTIL',
    'using': 'USING',
    'wend': 'WEND',
    'while': 'WHILE',
    'xor': 'XOR',
    '|': 'VBAR',
    '~': 'COMPLEMENT',
}

CLASSES = {
    'NAME': '[A-Za-z_](?!(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM[A-Z][a-z]))[A-Za-z0-9_]*+(?!\\.[0-9])',
    'NUMBER': '[0-9.](?:(?<=[0-9])[0-9]*+\\.?[0-9]*+(?:[eE][+-]?[0-9]++)?+|(?<=\\.)[0-9]++(?:[eE][+-]?[0-9]++)?+|(?<=0)(?:[xX][0-9a-fA-F]++|[bB][01]++))(?![A-Za-z0-9_])',
    '_NL': "[\n':Rr](?:(?<=\n)|(?<=')[^\n]*+\n|(?:(?<=:)[ \t]*+[Rr])?+(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM(?=[A-Z][a-z]))[^\n]*+\n)[ \t]*+(?:(?:'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)*+",
    'STRING': '"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"',
    'DOTTED': '[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++',
    'CHARACTER': '`(?:[^`\\\\\n]|\\\\[^\n])`',
}

SPELLINGS = {
    'MOD': 'Mod',
    'AND': 'And',
    'AS': 'As',
    'AUTO': 'Auto',
    'BYREF': 'ByRef',
    'BYVAL': 'ByVal',
    'CASE': 'Case',
    'CONST': 'Const',
    'DEFINE': 'Define',
    'DIM': 'Dim',
    'DO': 'Do',
    'ELSE': 'Else',
    'ELSEIF': 'ElseIf',
    'END': 'End',
    'ENDIF': 'EndIf',
    'ENDL': 'EndL',
    'ENDLOOP': 'EndLoop',
    'ENDW': 'EndW',
    'ENDWHILE': 'EndWhile',
    'EVENT': 'Event',
    'EXIT': 'Exit',
    'FOR': 'For',
    'FUNCTION': 'Function',
    'GOSUB': 'GoSub',
    'GOTO': 'GoTo',
    'IF': 'If',
    'INPUT': 'Input',
    'IS': 'Is',
    'LOOP': 'Loop',
    'NEXT': 'Next',
    'NOT': 'Not',
    'NV': 'NV',
    'OR': 'Or',
    'PAUSE': 'Pause',
    'PRINT': 'Print',
    'REPEAT': 'Repeat',
    'RETURN': 'Return',
    'RUN': 'Run',
    'SELECT': 'Select',
    'STARTUP': 'Startup',
    'STEP': 'Step',
    'SUB': 'Sub',
    'TASK': 'Task',
    'THEN': 'Then',
    'TO': 'To',
    'TYPE': 'Type',
    'UNTIL': 'Until',
    'USING': 'Using',
    'WEND': 'Wend',
    'WHILE': 'While',
    'XOR': 'Xor',
    'COLON': ':',
    'LPAR': '(',
    'RPAR': ')',
    'COMMA': ',',
    'STAR': '*',
    'SEMICOLON': ';',
    'HASH': '#',
    'EQUAL': '=',
    'QMARK': '?',
    'MINUS': '-',
    'PLUS': '+',
    'LSQB': '[',
    'RSQB': ']',
    'DOT': '.',
    'VBAR': '|',
    'PERCENT': '%',
    'AMPERSAND': '&',
    'CIRCUMFLEX': '^',
}

RULES = (
    (0, 'items', _none_0),
    (1, 'start', _module_1),
    (1, 'inline_statement', _auto_2),
    (1, 'leading', None),
    (1, 'name{leading}', _name_3),
    (2, 'items', _skip_4),
    (1, 'axes', _dotted_5),
    (1, 'inline_statement', _end_6),
    (1, 'leading', None),
    (1, 'inline_statement', _exit_7),
    (1, 'leading', None),
    (1, 'name{NAME}', _name_3),
    (0, 'print_list', _none_0),
    (1, 'inline_statement', _return_8),
    (1, 'leading', None),
    (1, 'leading', None),
    (1, 'leading', None),
    (1, 'leading', None),
    (2, 'items', _label_before_9),
    (1, 'target', None),
    (1, 'call', None),
    (1, 'inline_statement', _call_10),
    (0, 'body', _body_11),
    (1, 'ref{name{NAME}}', None),
    (1, 'call', None),
    (1, 'target', None),
    (1, 'target', None),
    (1, 'constants', _one_12),
    (2, 'inline_statement', _const_13),
    (1, 'declared', _name_3),
    (1, 'leading', None),
    (1, 'dims', None),
    (1, 'closed_dims', _plain_one_14),
    (2, 'inline_statement', _dim_15),
    (1, 'dims', None),
    (1, 'closed_dims', _one_12),
    (1, 'open_dims', _one_12),
    (2, 'inline_statement', _end_16),
    (2, 'inline_statement', _exit_17),
    (0, 'parameters', _none_0),
    (2, 'inline_statement', _gosub_18),
    (2, 'inline_statement', _goto_19),
    (2, 'inline_statement', _label_20),
    (1, 'name{word}', _name_3),
    (1, 'operand', _character_21),
    (1, 'operand', _number_22),
    (1, 'operand', _string_23),
    (1, 'or{atom}', None),
    (1, 'term{atom}', None),
    (1, 'bit_or{atom}', None),
    (1, 'not{atom}', None),
    (1, 'bit_and{atom}', None),
    (1, 'variable', None),
    (1, 'expr', None),
    (1, 'compare{atom}', None),
    (1, 'shift{atom}', None),
    (1, 'sum{atom}', None),
    (2, 'inline_statement', _input_24),
    (1, 'or{operand}', None),
    (1, 'term{operand}', None),
    (2, 'inline_statement', _bare_call_25),
    (1, 'bit_or{operand}', None),
    (1, 'not{operand}', None),
    (1, 'bit_and{operand}', None),
    (1, 'bare', _one_12),
    (1, 'compare{operand}', None),
    (1, 'shift{operand}', None),
    (1, 'sum{operand}', None),
    (2, 'inline_statement', _pause_26),
    (2, 'inline_statement', _print_27),
    (2, 'inline_statement', _run_28),
    (3, 'items', _more_29),
    (3, 'items', _more_29),
    (3, 'items', _more_29),
    (3, 'items', _more_29),
    (3, 'items', _more_29),
    (3, 'name{leading}', _name_empty_30),
    (1, 'exprs', _one_12),
    (3, 'inline_statement', _dim_31),
    (3, 'inline_statement', _gosub_32),
    (3, 'inline_statement', _goto_33),
    (2, 'unary{atom}', _complement_34),
    (2, 'unary{atom}', _minus_35),
    (2, 'negated', _not_36),
    (2, 'unary{atom}', _plus_37),
    (1, 'line_then', None),
    (2, 'unary{operand}', _complement_34),
    (3, 'name{NAME}', _name_empty_30),
    (2, 'unary{operand}', _minus_35),
    (2, 'unary{operand}', _plus_37),
    (1, 'print_last', _last_item_38),
    (3, 'inline_statement', _print_39),
    (0, 'task_body', _body_11),
    (1, 'seps', _none_40),
    (0, 'members', _none_0),
    (2, 'body', _skip_4),
    (3, 'inline_statement', _for_41),
    (2, 'body', _label_before_9),
    (3, 'inline_statement', _for_shared_42),
    (3, 'ref{name{leading}}', _member_43),
    (3, 'ref{name{NAME}}', _member_43),
    (3, 'select_head', _next_case_44),
    (1, 'slots', _one_omitted_45),
    (3, 'inline_statement', _assign_one_46),
    (3, 'inline_statement', _assign_47),
    (4, 'name{leading}', _name_arg_48),
    (4, 'name{leading}', _name_args_49),
    (4, 'name{leading}', _name_axes_50),
    (1, 'type', _type_51),
    (3, 'constant', _constant_52),
    (3, 'constants', _more_53),
    (4, 'inline_statement', _define_54),
    (3, 'closed_dims', _plain_more_55),
    (3, 'closed_dims', _more_53),
    (3, 'open_dims', _more_53),
    (3, 'typed', _variable_56),
    (3, 'valued', _valued_variable_57),
    (3, 'open_dims', _more_values_58),
    (3, 'closed_dims', _more_53),
    (3, 'open_dims', _more_53),
    (1, 'parameter', _parameter_59),
    (1, 'leading', None),
    (1, 'leading', None),
    (2, 'parameters', _none_60),
    (1, 'parameter_list', _one_12),
    (3, 'name{word}', _name_empty_30),
    (3, 'atom', _inner_61),
    (3, 'and{atom}', _and_62),
    (3, 'power{atom}', _binary_63),
    (3, 'bit_and_not{atom}', _binary_63),
    (3, 'bit_and{atom}', _binary_63),
    (3, 'bit_and_not{atom}', _binary_63),
    (3, 'bit_or_not{atom}', _binary_63),
    (3, 'bit_or{atom}', _binary_63),
    (3, 'bit_or_not{atom}', _binary_63),
    (3, 'compare_not{atom}', _binary_63),
    (3, 'compare{atom}', _binary_63),
    (3, 'compare_not{atom}', _binary_63),
    (3, 'compare{atom}', _binary_63),
    (2, 'line_then', _skip_4),
    (1, 'closed', _one_12),
    (1, 'line_tail', None),
    (1, 'closed', None),
    (1, 'inline', _one_12),
    (1, 'line_tail', _one_12),
    (4, 'line_if', _line_if_64),
    (3, 'ref{name{word}}', _member_43),
    (3, 'or{atom}', _or_65),
    (3, 'or{atom}', _xor_66),
    (3, 'shift{atom}', _binary_63),
    (3, 'sum{atom}', _binary_63),
    (3, 'sum{atom}', _binary_63),
    (3, 'term{atom}', _binary_63),
    (3, 'term{atom}', _mod_67),
    (3, 'term{atom}', _mod_67),
    (3, 'term{atom}', _binary_63),
    (4, 'inline_statement', _input_68),
    (4, 'inline_statement', _input_68),
    (1, 'formats', _one_12),
    (4, 'inline_statement', _input_69),
    (1, 'end_loop', None),
    (1, 'end_loop', None),
    (4, 'inline_statement', _loop_70),
    (4, 'name{NAME}', _name_arg_48),
    (4, 'name{NAME}', _name_args_49),
    (4, 'name{NAME}', _name_axes_50),
    (3, 'and{operand}', _and_62),
    (3, 'power{operand}', _binary_63),
    (3, 'bare', _more_53),
    (3, 'bit_and_not{operand}', _binary_63),
    (3, 'bit_and{operand}', _binary_63),
    (3, 'bit_and_not{operand}', _binary_63),
    (3, 'bit_or_not{operand}', _binary_63),
    (3, 'bit_or{operand}', _binary_63),
    (3, 'bit_or_not{operand}', _binary_63),
    (3, 'compare_not{operand}', _binary_63),
    (3, 'compare{operand}', _binary_63),
    (3, 'compare_not{operand}', _binary_63),
    (3, 'compare{operand}', _binary_63),
    (3, 'or{operand}', _or_65),
    (3, 'or{operand}', _xor_66),
    (3, 'shift{operand}', _binary_63),
    (3, 'sum{operand}', _binary_63),
    (3, 'sum{operand}', _binary_63),
    (3, 'term{operand}', _binary_63),
    (3, 'term{operand}', _mod_67),
    (3, 'term{operand}', _mod_67),
    (3, 'term{operand}', _binary_63),
    (3, 'print_list', _print_item_71),
    (3, 'print_list', _print_item_71),
    (2, 'seps', _skip_4),
    (4, 'inline_statement', _for_72),
    (3, 'body', _more_29),
    (3, 'body', _more_29),
    (3, 'body', _more_29),
    (1, 'test', _test_73),
    (1, 'tests', _one_12),
    (4, 'select', _last_case_74),
    (2, 'slots', _one_75),
    (4, 'inline_statement', _assign_same_76),
    (2, 'slots', _next_omitted_77),
    (2, 'values', _last_78),
    (4, 'inline_statement', _assign_79),
    (3, 'several', _pair_80),
    (3, 'several', _more_53),
    (3, 'exprs', _more_53),
    (4, 'declared', _name_arg_48),
    (4, 'declared', _name_args_49),
    (2, 'parameter', _parameter_by_reference_81),
    (2, 'parameter', _parameter_by_value_82),
    (3, 'parameters', _inner_61),
    (4, 'name{word}', _name_arg_48),
    (4, 'name{word}', _name_args_49),
    (4, 'name{word}', _name_axes_50),
    (1, 'end_if', None),
    (1, 'if_tail', _none_40),
    (5, 'statement', _if_do_83),
    (2, 'inline', _skip_4),
    (5, 'inline_statement', _input_84),
    (2, 'end_loop', _skip_4),
    (5, 'inline_statement', _print_85),
    (3, 'print_last', _last_using_86),
    (5, 'inline_statement', _repeat_87),
    (5, 'select_head', _select_88),
    (5, 'declaration', _startup_89),
    (2, 'task_body', _skip_4),
    (2, 'task_body', _label_before_9),
    (1, 'member_list', _one_12),
    (1, 'end_while', None),
    (1, 'end_while', None),
    (1, 'end_while', None),
    (5, 'inline_statement', _while_90),
    (3, 'case', _case_else_91),
    (3, 'case', _case_92),
    (3, 'slots', _more_29),
    (3, 'type', _sized_type_93),
    (5, 'constant', _constant_94),
    (5, 'valued', _typed_variable_95),
    (6, 'declaration', _event_96),
    (3, 'parameter', _parameter_97),
    (3, 'parameter', _parameter_98),
    (3, 'parameter_list', _more_53),
    (2, 'else_if', _skip_4),
    (2, 'end_if', _skip_4),
    (6, 'statement', _if_99),
    (2, 'line_else', _skip_4),
    (6, 'line_if', _line_if_else_100),
    (3, 'closed', _more_53),
    (3, 'inline', _more_53),
    (3, 'line_tail', _more_53),
    (6, 'inline_statement', _input_101),
    (6, 'inline_statement', _input_101),
    (3, 'formats', _pair_80),
    (6, 'inline_statement', _print_102),
    (4, 'print_last', _last_open_103),
    (5, 'print_list', _print_using_104),
    (6, 'select', _select_nothing_105),
    (6, 'declaration', _task_106),
    (3, 'task_body', _more_29),
    (3, 'task_body', _more_29),
    (3, 'task_body', _more_29),
    (3, 'task_body', _more_29),
    (3, 'task_body', _more_29),
    (6, 'declaration', _user_type_107),
    (3, 'members', _extend_108),
    (3, 'members', _extend_108),
    (2, 'end_while', _skip_4),
    (5, 'shared', _shared_further_109),
    (6, 'ref{name{leading}}', _member_args_110),
    (6, 'ref{name{NAME}}', _member_args_110),
    (3, 'test', _test_is_111),
    (3, 'test', _test_is_111),
    (3, 'test', _test_range_112),
    (3, 'tests', _more_53),
    (7, 'for_head', _for_head_113),
    (4, 'parameter', _parameter_by_reference_114),
    (4, 'parameter', _parameter_by_reference_115),
    (4, 'parameter', _parameter_by_value_116),
    (4, 'parameter', _parameter_by_value_117),
    (7, 'routine', _function_118),
    (6, 'ref{name{word}}', _member_args_110),
    (7, 'inline_statement', _input_119),
    (7, 'inline_statement', _input_119),
    (7, 'inline_statement', _input_120),
    (7, 'routine', _sub_121),
    (4, 'members', _extend_122),
    (4, 'members', _extend_122),
    (3, 'member_list', _more_53),
    (6, 'shared', _shared_123),
    (5, 'parameter', _parameter_124),
    (4, 'if_tail', _third_125),
    (7, 'print_list', _print_using_two_126),
    (7, 'print_list', _print_using_two_126),
    (9, 'for_head', _for_head_127),
    (6, 'parameter', _parameter_by_reference_128),
    (6, 'parameter', _parameter_by_value_129),
    (9, 'routine', _function_130),
    (5, 'if_tail', _else_if_131),
    (5, 'if_tail', _else_if_131),
    (6, 'closed_if', _line_if_else_100),
    (9, 'inline_statement', _input_132),
    (9, 'inline_statement', _input_132),
)

ROWS = (
    '1=items 2=start d0',
    '3=AUTO 4=BYREF,BYVAL,NV,STEP,TO,USING,leading 5=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 11=EVENT 12=EXIT 13=FOR 14=FUNCTION 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 28=STARTUP 29=SUB 30=TASK 31=TYPE 32=WHILE 33=_NL 34=axes 35=call 36=declaration,routine 37=for_head 38=inline_statement,select,statement 39=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target d1',
    '',
    'r2=COLON,ELSE,_NL d3',
    '45=LPAR 46=LSQB d4',
    'd5',
    '47=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 48=constant 49=constants',
    '50=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 52=NV 53=closed_dims 54=declared 55=dims 56=open_dims 57=typed 58=valued',
    'd6',
    '59=NAME d7',
    '60=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d8',
    '61=EVENT,FOR,FUNCTION,LOOP,REPEAT,SELECT,SUB,TASK,WHILE,exit_kind d9',
    '62=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '63=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '64=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word 65=HASH',
    '66=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word 67=HASH',
    '68=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 83=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 89=HASH 90=STRING 91=axes,variable 84=name{word},ref{name{word}} d10',
    '92=COLON,_NL,sep',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 93=COMPLEMENT 9=DOTTED 94=LPAR 95=LSQB 96=MINUS 74=NOT 75=NUMBER 97=PLUS 77=STRING 98=and{operand},bit_and_not{operand},bit_or_not{operand},compare_not{operand},negated,not{operand} 99=axes,operand,power{operand},unary{operand},variable 100=bare 101=bit_and{operand} 102=bit_or{operand} 103=compare{operand} 84=name{word},ref{name{word}} 104=or{operand} 105=shift{operand} 106=sum{operand} 107=term{operand} d11',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 108=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '109=HASH 110=print_list d12',
    '111=COLON,_NL,sep',
    'd13',
    '112=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d14',
    '113=CASE',
    '114=COLON,_NL,sep d15',
    '115=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '116=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d16',
    '117=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d17',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 118=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd18',
    'r19=EQUAL d20',
    'd21',
    '119=COLON 120=_NL',
    '121=body 122=shared d22',
    '123=COLON 124=_NL',
    '125=_NL',
    'r23=DOT,EQUAL d24',
    '126=DOT d25',
    '127=DOT d26',
    '128=body d22',
    '129=EQUAL',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 130=RPAR 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 131=expr 84=name{word},ref{name{word}} 85=or{atom} 132=several 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 133=expr 134=exprs 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '135=AS 136=EQUAL',
    'd27',
    '137=COMMA d28',
    '138=EQUAL',
    '139=LPAR d29',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 53=closed_dims 54=declared 140=dims 56=open_dims 57=typed 58=valued d30',
    '141=COMMA d31',
    '142=AS 143=EQUAL d32',
    'd33',
    '144=COMMA d34',
    'd35',
    'd36',
    'd37',
    '145=COLON,_NL,sep',
    'd38',
    '146=EQUAL',
    '147=LPAR 148=parameters d39',
    'd40',
    '149=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word',
    'd41',
    '150=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word',
    'd42',
    '151=LPAR 152=LSQB d43',
    'd44',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 153=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 154=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 155=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 156=bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd45',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 157=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    'd46',
    '158=AND d47',
    '159=CIRCUMFLEX d48',
    '160=AMPERSAND d49',
    '161=VBAR d50',
    '162=COMPARE 163=EQUAL d51',
    '164=DO 165=THEN 166=line_then',
    '167=DOT d52',
    '168=OR 169=XOR d53',
    '170=SHIFT d54',
    '171=MINUS 172=PLUS d55',
    '173=DIVIDE 174=MOD 175=PERCENT 176=STAR d56',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 177=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '178=COMMA 179=SEMICOLON',
    '180=USING d57',
    '181=body d22',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 182=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 183=RPAR 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 184=expr 84=name{word},ref{name{word}} 85=or{atom} 185=several 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 133=expr 186=exprs 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 187=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 188=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '189=AND d58',
    '190=CIRCUMFLEX d59',
    '191=COMMA d60',
    '192=AMPERSAND d61',
    '193=VBAR d62',
    '194=COMPARE 195=EQUAL d63',
    '196=OR 197=XOR d64',
    '198=SHIFT d65',
    '199=MINUS 200=PLUS d66',
    '201=DIVIDE 202=MOD 203=PERCENT 204=STAR d67',
    'd68',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 205=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 206=expr 84=name{word},ref{name{word}} 85=or{atom} 207=print_last 86=shift{atom} 87=sum{atom} 88=term{atom} d69',
    '208=body d22',
    'd70',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 209=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '210=body d22',
    '147=LPAR 211=parameters d39',
    '212=COLON,_NL,sep',
    '213=COLON,_NL,sep 214=seps',
    '215=COLON,_NL,sep',
    'd71',
    'd72',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 217=NEXT 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 219=for_head 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '222=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd73',
    'd74',
    'd75',
    '223=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '224=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 225=CASE 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 226=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 227=case 37=for_head 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 228=COMMA 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 229=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 230=slots 87=sum{atom} 88=term{atom} 231=values',
    'd76',
    '232=COMMA 233=RPAR',
    '234=COMMA 235=RPAR',
    'd77',
    '236=COMMA 237=RSQB',
    '238=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 239=type',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 240=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '47=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 241=constant',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 242=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 243=expr 84=name{word},ref{name{word}} 85=or{atom} 244=several 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd78',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 245=declared 246=typed 247=valued',
    '238=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 248=type',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 249=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '250=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 251=declared 84=name{word},ref{name{word}} 252=shift{atom} 87=sum{atom} 88=term{atom} 253=typed 254=valued',
    '255=body d22',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 256=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '257=AUTO,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 258=BYREF 259=BYVAL 260=RPAR 261=parameter 262=parameter_list',
    '263=AS 264=COLON,_NL,sep',
    'd79',
    'd80',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 265=RPAR 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 266=expr 84=name{word},ref{name{word}} 85=or{atom} 267=several 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 133=expr 268=exprs 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd81',
    '269=RPAR',
    'd82',
    'd83',
    'd84',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 270=bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 271=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 272=compare_not{atom} 273=compare{atom} 84=name{word},ref{name{word}} 274=negated 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 275=bit_and_not{atom},compare_not{atom} 276=bit_and{atom} 82=compare{atom} 84=name{word},ref{name{word}} 277=negated 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 278=negated 279=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 280=negated 281=shift{atom} 87=sum{atom} 88=term{atom}',
    '282=body d22',
    '283=_NL d85',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 284=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 285=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 286=closed 287=closed_if 37=for_head 288=inline 289=inline_statement,select 290=line_if 291=line_tail 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '292=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 293=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 294=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 295=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 296=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 297=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 298=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 299=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 300=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 301=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '302=COMMA',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 303=axes,variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 304=axes,variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 305=expr 306=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 307=END 308=ENDL 309=ENDLOOP 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 310=end_loop 37=for_head 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    'd86',
    'd87',
    '232=COMMA 311=RPAR',
    '234=COMMA 312=RPAR',
    '236=COMMA 313=RSQB',
    'd88',
    'd89',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 314=bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 315=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 316=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 317=compare_not{atom} 318=compare{atom} 84=name{word},ref{name{word}} 319=negated 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 320=bit_and_not{atom},compare_not{atom} 321=bit_and{atom} 82=compare{atom} 84=name{word},ref{name{word}} 322=negated 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 323=negated 324=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 325=negated 326=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 327=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 328=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 329=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 330=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 331=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 332=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 333=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 334=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 335=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '336=COMMA',
    '337=COMMA 338=SEMICOLON 339=USING d90',
    'd91',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 340=UNTIL 32=WHILE 218=_NL 34=axes 35=call 37=for_head 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '213=COLON,_NL,sep 341=seps',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 342=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 37=for_head 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '343=COLON,_NL,sep',
    '344=task_body d92',
    'd93',
    '345=COLON,_NL,sep 346=members d94',
    '347=body d22',
    'd95',
    '348=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d96',
    'd97',
    '349=body 350=shared d22',
    '351=COLON 352=_NL',
    '353=_NL',
    'd98',
    '354=LPAR d99',
    '355=LPAR d100',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 356=ELSE 357=IS 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 358=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom} 359=test 360=tests',
    '59=NAME 361=SELECT d7',
    'd101',
    'd102',
    '362=COMMA 363=SEMICOLON d103',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 364=COMMA 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 365=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '366=SEMICOLON d104',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 367=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd105',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 368=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd106',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 369=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd107',
    '370=STAR d108',
    '371=EQUAL',
    'd109',
    'd110',
    'd111',
    '232=COMMA 372=RPAR',
    '234=COMMA 373=RPAR',
    '142=AS 143=EQUAL d112',
    'd113',
    'd114',
    '374=EQUAL d115',
    'd116',
    'r29=AS,EQUAL 375=LPAR 152=LSQB d43',
    '142=AS 143=EQUAL',
    '170=SHIFT d117',
    'd118',
    'd119',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 376=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 37=for_head 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '377=TO',
    '378=AS 379=LPAR d120',
    '380=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d121',
    '381=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d122',
    'd123',
    'd124',
    '382=COMMA 383=RPAR',
    '238=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 384=type',
    '385=body d22',
    'd125',
    '232=COMMA 386=RPAR',
    '234=COMMA 387=RPAR',
    '236=COMMA 388=RSQB',
    'd126',
    'd127',
    'd128',
    'd129',
    '162=COMPARE 163=EQUAL d130',
    'd131',
    'd132',
    '160=AMPERSAND d133',
    'd134',
    'd135',
    '170=SHIFT d136',
    'd137',
    '170=SHIFT d138',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 389=ELSE 390=ELSEIF,else_if 391=END 392=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 393=end_if 37=for_head 394=if_tail 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '395=body d22',
    'd139',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 396=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '397=ELSE,line_else',
    'd140',
    '398=COLON r141=_NL d142',
    'd143',
    'd144',
    'd145',
    '399=LPAR d146',
    '158=AND d147',
    '158=AND d148',
    '171=MINUS 172=PLUS d149',
    '173=DIVIDE 174=MOD 175=PERCENT 176=STAR d150',
    '173=DIVIDE 174=MOD 175=PERCENT 176=STAR d151',
    '159=CIRCUMFLEX d152',
    '159=CIRCUMFLEX d153',
    '159=CIRCUMFLEX d154',
    '159=CIRCUMFLEX d155',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 400=STRING 401=axes,variable 84=name{word},ref{name{word}}',
    '402=USING d156',
    '403=USING d157',
    '404=COMMA d158',
    'd159',
    '405=LOOP 59=NAME d7',
    'd160',
    'd161',
    'd162',
    'd163',
    'd164',
    'd165',
    'd166',
    'd167',
    'd168',
    'd169',
    '162=COMPARE 163=EQUAL d170',
    'd171',
    'd172',
    '160=AMPERSAND d173',
    'd174',
    'd175',
    '170=SHIFT d176',
    'd177',
    '170=SHIFT d178',
    '158=AND d179',
    '158=AND d180',
    '171=MINUS 172=PLUS d181',
    '173=DIVIDE 174=MOD 175=PERCENT 176=STAR d182',
    '173=DIVIDE 174=MOD 175=PERCENT 176=STAR d183',
    '159=CIRCUMFLEX d184',
    '159=CIRCUMFLEX d185',
    '159=CIRCUMFLEX d186',
    '159=CIRCUMFLEX d187',
    '406=print_list d12',
    'd188',
    'd189',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 407=expr 408=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 409=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '225=CASE 345=COLON,_NL,sep 410=END 411=case',
    '59=NAME 412=STARTUP d7',
    '413=body d22',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 414=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 415=END 12=EXIT 13=FOR 14=FUNCTION 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 29=SUB 32=WHILE 416=_NL 34=axes 35=call 37=for_head 417=inline_statement,select,statement 418=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 419=routine 43=select_head 44=target',
    'd190',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 420=DIM 421=END 422=declared 423=member_list 424=typed',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 425=END 426=ENDW 427=ENDWHILE 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 428=WEND 32=WHILE 218=_NL 34=axes 35=call 429=end_while 37=for_head 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    'd191',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 430=NEXT 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 219=for_head 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '431=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd192',
    'd193',
    'd194',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 133=expr 432=exprs 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 133=expr 433=exprs 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '434=COLON,_NL,sep',
    '435=COMPARE 436=EQUAL',
    '437=TO d195',
    'd196',
    '438=COLON,_NL,sep 439=COMMA',
    'd197',
    'd198',
    'd199',
    'd200',
    '440=COMMA d201',
    'd202',
    'd203',
    'd204',
    'd205',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 441=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 442=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd206',
    'd207',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 443=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 265=RPAR 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 444=expr 84=name{word},ref{name{word}} 85=or{atom} 445=several 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '446=EVENT 59=NAME d7',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 447=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '238=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 448=type',
    '449=RPAR',
    '450=AS 451=LPAR d208',
    '452=AS 453=LPAR d209',
    '257=AUTO,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 258=BYREF 259=BYVAL 454=parameter',
    'd210',
    '455=COLON,_NL,sep',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 456=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 37=for_head 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    'd211',
    'd212',
    'd213',
    '457=COLON,_NL,sep 458=IF',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 459=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '460=IF 59=NAME d7',
    'd214',
    'd215',
    'd216',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 389=ELSE 390=ELSEIF,else_if 391=END 392=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 393=end_if 37=for_head 461=if_tail 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '462=THEN,line_then',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 463=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 464=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 37=for_head 465=inline 289=inline_statement,select 290=line_if 466=line_tail 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 285=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 467=closed_if 37=for_head 468=inline_statement,select 469=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target d217',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 133=expr 470=exprs 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '471=COMMA 472=SEMICOLON',
    '473=USING d218',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 305=expr 474=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 305=expr 475=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 476=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd219',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 206=expr 84=name{word},ref{name{word}} 85=or{atom} 477=print_last 86=shift{atom} 87=sum{atom} 88=term{atom} d220',
    '478=COMMA 479=SEMICOLON d158',
    'd221',
    'd222',
    '480=SELECT',
    'd223',
    'd224',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 481=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 37=for_head 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    'd225',
    '59=NAME 482=TASK d7',
    'd226',
    '483=COLON 484=_NL',
    '485=_NL',
    '486=COLON 487=_NL',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 422=declared 488=member_list 424=typed',
    '489=TYPE',
    '490=AS',
    '491=COLON 492=COMMA 493=_NL',
    'd227',
    '59=NAME 494=WHILE d7',
    'd228',
    'd229',
    'd230',
    'd231',
    '495=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d96',
    '496=COMMA d98',
    '236=COMMA 497=RPAR',
    '236=COMMA 498=RPAR',
    'd232',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 499=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 500=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 501=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd233',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 357=IS 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 358=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom} 502=test',
    'd234',
    'd235',
    'd236',
    'd237',
    '232=COMMA 503=RPAR',
    '234=COMMA 504=RPAR',
    'd238',
    '505=COLON,_NL,sep 506=STEP',
    'd239',
    '507=AS d240',
    '238=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 508=type',
    '509=RPAR',
    '238=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 510=type',
    '511=RPAR',
    'd241',
    '512=body d22',
    '513=FUNCTION 59=NAME d7',
    '514=body d22',
    'd242',
    '515=DO 516=THEN',
    'd243',
    'd244',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 284=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 285=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 517=closed 287=closed_if 37=for_head 288=inline 289=inline_statement,select 290=line_if 291=line_tail 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    'd245',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 518=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '519=COLON d141',
    'd246',
    'd247',
    'd248',
    'd249',
    '236=COMMA 520=RPAR',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 521=axes,variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 522=axes,variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 305=expr 523=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd250',
    'd251',
    'd252',
    'd253',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 524=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom} d254',
    'd255',
    'd256',
    '59=NAME 525=SUB d7',
    'd257',
    'd258',
    'd259',
    'd260',
    'd261',
    'd262',
    '526=COLON 492=COMMA 527=_NL',
    'd263',
    '238=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 528=type',
    'd264',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 422=declared 529=typed',
    'd265',
    'd266',
    '530=COMMA d191',
    'd267',
    'd268',
    'd269',
    'd270',
    'd271',
    'd272',
    'd273',
    'r206=AS,EQUAL d211',
    'r207=AS,EQUAL d212',
    'd274',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 531=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '238=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 532=type',
    'd275',
    '533=AS d276',
    'd277',
    '534=AS d278',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 535=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 37=for_head 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    'd279',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 391=END 392=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 536=end_if 37=for_head 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '537=body d22',
    '538=body d22',
    '539=ELSE,line_else',
    '166=THEN,line_then',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 464=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 37=for_head 468=inline_statement,select 469=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target d217',
    'd280',
    '540=USING d281',
    '541=USING d282',
    'd283',
    '542=COMMA 543=SEMICOLON d252',
    'd284',
    'd285',
    'd286',
    'd115',
    'd287',
    'd288',
    '544=COLON,_NL,sep',
    'd289',
    '238=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 545=type',
    '238=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 546=type',
    '547=FUNCTION 59=NAME d7',
    'd290',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 389=ELSE 390=ELSEIF,else_if 391=END 392=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 393=end_if 37=for_head 548=if_tail 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 216=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 389=ELSE 390=ELSEIF,else_if 391=END 392=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 218=_NL 34=axes 35=call 393=end_if 37=for_head 549=if_tail 220=inline_statement,select,statement 221=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 463=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 285=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 550=closed 287=closed_if 37=for_head 288=inline 289=inline_statement,select 290=line_if 466=line_tail 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 305=expr 551=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 305=expr 552=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd291',
    'd292',
    'd293',
    'd294',
    'd295',
    'd296',
    'd297',
    'd298',
    'd299',
    'd300',
    'd301',
)

TABLES = Tables(TOKEN, CONTINUED, LITERALS, CLASSES, RULES, ROWS, 2)
