"""The tables of grammars/mint.lark; written by `python -m motionlang.lang.grammar`, not by hand."""

# ruff: noqa
# mypy: ignore-errors
# fmt: off

from motionlang.lang.tables import Tables
from motionlang.mint.build import *
from motionlang.mint.nodes import *


def _xor_0(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, "Xor", v0, v2)


def _line_if_else_1(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    v5 = V[-1]
    del V[-5:]
    V[-1] = If(v0, v1, v3, v5)


def _inner_2(V, T):
    V.pop()
    v1 = V.pop()
    V[-1] = v1


def _dim_3(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Dim(v0, v2, v1 is not None)


def _one_4(V, T):
    v0 = V[-1]
    V[-1] = [v0]


def _first_5(V, T):
    V.pop()


def _last_using_6(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = PrintItem(v0.at, v0, v2, "")


def _for_7(V, T):
    v0 = V[-10]
    v1 = V[-9]
    v3 = V[-7]
    v5 = V[-5]
    v7 = V[-3]
    v9 = V[-1]
    del V[-9:]
    V[-1] = counted(For(v0, Name(v1, T[v1]), v3, v5, None, v7), v9, T)


def _binary_8(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, T[v1], v0, v2)


def _input_9(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Input(v0, v4, None if None is None else String(None, string(T[None])), None or [], v2)


def _user_type_10(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    del V[-5:]
    V[-1] = UserType(v0, T[v1], v3)


def _parameter_by_value_11(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v2 = V[-4]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Parameter(v0, T[v1], v5, False, v2 is not None)


def _more_12(V, T):
    V.pop()
    v1 = V.pop()
    V[-1].append(v1)


def _member_13(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Member(v0.at, v0, T[v2])


def _case_else_14(V, T):
    V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Case(v0, [], [])


def _body_15(V, T):
    V.append(body(V))


def _name_16(V, T):
    v0 = V[-1]
    V[-1] = Name(v0, T[v0])


def _parameter_by_value_17(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v1], None, False, None is not None)


def _const_18(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Const(v0, T[v1], None, v3)


def _end_19(V, T):
    v0 = V[-1]
    V[-1] = End(v0, None if None is None else T[None])


def _mod_20(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, "Mod", v0, v2)


def _repeat_21(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Repeat(v0, v2, v4)


def _case_22(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Case(v0, v1, [])


def _or_23(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, "Or", v0, v2)


def _input_24(V, T):
    v0 = V[-9]
    v2 = V[-7]
    v4 = V[-5]
    v6 = V[-3]
    v8 = V[-1]
    del V[-8:]
    V[-1] = Input(v0, v6, None if v4 is None else String(v4, string(T[v4])), v8 or [], v2)


def _startup_25(V, T):
    v0 = V[-5]
    v2 = V[-3]
    del V[-4:]
    V[-1] = Startup(v0, v2)


def _loop_26(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Loop(v0, v2)


def _number_27(V, T):
    v0 = V[-1]
    V[-1] = Number(v0, number(T[v0]))


def _parameter_by_reference_28(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v1], None, True, None is not None)


def _run_29(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Run(v0, T[v1])


def _and_30(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, "And", v0, v2)


def _label_before_31(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = label_before(v0, v1, T)


def _while_32(V, T):
    v0 = V[-5]
    v1 = V[-4]
    v3 = V[-2]
    del V[-4:]
    V[-1] = While(v0, v1, v3)


def _more_33(V, T):
    v2 = V.pop()
    V.pop()
    V[-1].append(v2)


def _print_item_34(V, T):
    v2 = V.pop()
    v1 = V.pop()
    V[-1].append(PrintItem(v1.at, v1, [], T[v2]))


def _else_if_35(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v4 = V[-2]
    v5 = V[-1]
    del V[-5:]
    V[-1] = [If(v0, v1, v4, v5)]


def _assign_36(V, T):
    v0 = V[-4]
    v2 = V[-2]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Assign(v0.at, v0, v2, v3 is not None)


def _extend_37(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = extended(v0, v1)


def _test_38(V, T):
    v0 = V[-1]
    V[-1] = CaseTest(v0.at, "=", v0)


def _none_39(V, T):
    V.append([])


def _last_case_40(V, T):
    v0 = V[-4]
    v1 = V[-3]
    del V[-3:]
    V[-1] = last_case(v0, v1)


def _function_41(V, T):
    v0 = V[-7]
    v1 = V[-6]
    v2 = V[-5]
    v4 = V[-3]
    del V[-6:]
    V[-1] = Sub(v0, T[v1], v2, v4, True, None)


def _print_42(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Print(v0, v1 if v2 is None else [*v1, v2], None)


def _last_item_43(V, T):
    v0 = V[-1]
    V[-1] = PrintItem(v0.at, v0, [], "")


def _name_args_44(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Name(v0, T[v0], v2)


def _third_45(V, T):
    v2 = V[-2]
    del V[-3:]
    V[-1] = v2


def _for_46(V, T):
    v0 = V[-11]
    v1 = V[-10]
    v3 = V[-8]
    v5 = V[-6]
    v7 = V[-4]
    v9 = V[-2]
    del V[-10:]
    V[-1] = counted(For(v0, Name(v1, T[v1]), v3, v5, v7, v9), None, T)


def _name_axes_47(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Name(v0, T[v0], v2, True)


def _select_48(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Select(v0, v2, [v4])


def _parameter_by_reference_49(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v2 = V[-4]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Parameter(v0, T[v1], v5, True, v2 is not None)


def _for_50(V, T):
    v0 = V[-9]
    v1 = V[-8]
    v3 = V[-6]
    v5 = V[-4]
    v7 = V[-2]
    del V[-8:]
    V[-1] = counted(For(v0, Name(v1, T[v1]), v3, v5, None, v7), None, T)


def _module_51(V, T):
    v0 = V[-1]
    V[-1] = module(v0)


def _more_values_52(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = more_values(v0, v2)


def _extend_53(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = extended(v0, v2)


def _member_args_54(V, T):
    v0 = V[-6]
    v2 = V[-4]
    v4 = V[-2]
    del V[-5:]
    V[-1] = Member(v0.at, v0, T[v2], v4)


def _plain_more_55(V, T):
    v2 = V.pop()
    V.pop()
    V[-1].append(declare(v2))


def _assign_56(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Assign(v0.at, v0, v2, None is not None)


def _name_empty_57(V, T):
    V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Name(v0, T[v0], [])


def _parameter_58(V, T):
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v0], None, False, None is not None)


def _next_case_59(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = next_case(v0, v1, v2)


def _input_60(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Input(v0, v3, None if v1 is None else String(v1, string(T[v1])), None or [], None)


def _print_61(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Print(v0, v4 if None is None else [*v4, None], v2)


def _line_if_62(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = If(v0, v1, v3, [])


def _valued_variable_63(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = declare(v0, None, v2)


def _none_64(V, T):
    V.pop()
    V[-1] = []


def _input_65(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Input(v0, v1, None if None is None else String(None, string(T[None])), v3 or [], None)


def _character_66(V, T):
    v0 = V[-1]
    V[-1] = Number(v0, ord(string(T[v0])))


def _bare_call_67(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Call(v0, Name(v0, T[v0], v1))


def _parameter_68(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v0], None, False, v1 is not None)


def _type_69(V, T):
    v0 = V[-1]
    V[-1] = TypeName(v0, T[v0])


def _string_70(V, T):
    v0 = V[-1]
    V[-1] = String(v0, string(T[v0]))


def _define_71(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Define(v0, T[v1], v3)


def _pair_72(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = [v0, v2]


def _dotted_73(V, T):
    v0 = V[-1]
    V[-1] = dotted(v0, T[v0])


def _minus_74(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Unary(v0, "-", v1)


def _if_75(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v4 = V[-2]
    v5 = V[-1]
    del V[-5:]
    V[-1] = If(v0, v1, v4, v5)


def _last_open_76(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = PrintItem(v0.at, v0, [v2], ",")


def _exit_77(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Exit(v0, "" if v1 is None else T[v1].lower())


def _input_78(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Input(v0, v1, None if None is None else String(None, string(T[None])), None or [], None)


def _for_79(V, T):
    v0 = V[-12]
    v1 = V[-11]
    v3 = V[-9]
    v5 = V[-7]
    v7 = V[-5]
    v9 = V[-3]
    v11 = V[-1]
    del V[-11:]
    V[-1] = counted(For(v0, Name(v1, T[v1]), v3, v5, v7, v9), v11, T)


def _none_80(V, T):
    V[-1] = []


def _parameter_by_reference_81(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Parameter(v0, T[v1], None, True, v2 is not None)


def _test_range_82(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = CaseTest(v0.at, "To", v0, v2)


def _goto_83(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Jump(v0, "goto", T[v1])


def _test_is_84(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = CaseTest(v0, T[v1], v2)


def _function_85(V, T):
    v0 = V[-9]
    v1 = V[-8]
    v2 = V[-7]
    v4 = V[-5]
    v6 = V[-3]
    del V[-8:]
    V[-1] = Sub(v0, T[v1], v2, v6, True, v4)


def _goto_86(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Jump(v0, "goto", T[v2])


def _event_87(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    del V[-5:]
    V[-1] = Event(v0, T[v1], v3)


def _pause_88(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Pause(v0, v1)


def _parameter_89(V, T):
    v0 = V[-5]
    v1 = V[-4]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Parameter(v0, T[v0], v4, False, v1 is not None)


def _select_nothing_90(V, T):
    v0 = V[-6]
    v2 = V[-4]
    del V[-5:]
    V[-1] = Select(v0, v2, [])


def _typed_variable_91(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = declare(v0, v2, v4)


def _sized_type_92(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = TypeName(v0, T[v0], v2)


def _const_93(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Const(v0, T[v1], v3, v5)


def _gosub_94(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Jump(v0, "gosub", T[v1])


def _input_95(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Input(v0, v3, None if v1 is None else String(v1, string(T[v1])), v5 or [], None)


def _dim_96(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Dim(v0, v1, None is not None)


def _input_97(V, T):
    v0 = V[-7]
    v2 = V[-5]
    v4 = V[-3]
    v6 = V[-1]
    del V[-6:]
    V[-1] = Input(v0, v6, None if v4 is None else String(v4, string(T[v4])), None or [], v2)


def _variable_98(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = declare(v0, v2)


def _parameter_by_reference_99(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Parameter(v0, T[v1], v3, True, None is not None)


def _complement_100(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Unary(v0, "~", v1)


def _sub_101(V, T):
    v0 = V[-7]
    v1 = V[-6]
    v2 = V[-5]
    v4 = V[-3]
    del V[-6:]
    V[-1] = Sub(v0, T[v1], v2, v4)


def _auto_102(V, T):
    v0 = V[-1]
    V[-1] = Auto(v0)


def _not_103(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Unary(v0, "Not", v1)


def _parameter_104(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v0], v2, False, None is not None)


def _plus_105(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Unary(v0, "+", v1)


def _print_using_two_106(V, T):
    v1 = V[-6]
    v3 = V[-4]
    v5 = V[-2]
    v6 = V[-1]
    del V[-6:]
    V[-1].append(PrintItem(v1.at, v1, [v3, v5], T[v6]))


def _return_107(V, T):
    v0 = V[-1]
    V[-1] = Return(v0)


def _exit_108(V, T):
    v0 = V[-1]
    V[-1] = Exit(v0, "" if None is None else T[None].lower())


def _call_109(V, T):
    v0 = V[-1]
    V[-1] = Call(v0.at, v0)


def _print_using_110(V, T):
    v1 = V[-4]
    v3 = V[-2]
    v4 = V[-1]
    del V[-4:]
    V[-1].append(PrintItem(v1.at, v1, [v3], T[v4]))


def _parameter_by_value_111(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Parameter(v0, T[v1], None, False, v2 is not None)


def _plain_one_112(V, T):
    v0 = V[-1]
    V[-1] = [declare(v0)]


def _input_113(V, T):
    v0 = V[-7]
    v2 = V[-5]
    v4 = V[-3]
    v6 = V[-1]
    del V[-6:]
    V[-1] = Input(v0, v4, None if None is None else String(None, string(T[None])), v6 or [], v2)


def _parameter_by_value_114(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Parameter(v0, T[v1], v3, False, None is not None)


def _gosub_115(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Jump(v0, "gosub", T[v2])


def _label_116(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Label(v0, T[v1])


def _task_117(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    del V[-5:]
    V[-1] = task(v0, T[v1], v3)


def _print_118(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Print(v0, v1 if None is None else [*v1, None], None)


def _print_119(V, T):
    v0 = V[-6]
    v2 = V[-4]
    v4 = V[-2]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Print(v0, v4 if v5 is None else [*v4, v5], v2)


def _end_120(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = End(v0, None if v1 is None else T[v1])


TOKEN = '(?:[ \t]+)?((?:(?:\'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)++|(?!(?:[Rr][Ee][Mm]\\b|REM[A-Z][a-z]))[A-Za-z_][A-Za-z0-9_]*+(?!\\.[0-9])|[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++|(?:0[xX][0-9a-fA-F]++|0[bB][01]++|(?:[0-9]++\\.?[0-9]*+|\\.[0-9]++)(?:[eE][+-]?[0-9]++)?+)(?![A-Za-z0-9_])|"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"|`(?:[^`\\\\\n]|\\\\[^\n])`|(?:/|\\\\)|<<|<=|<>|>=|>>|"[^\\n]*|[0-9][A-Za-z0-9_]*|.)'

CONTINUED = '(?:[ \t]+|[\\\\_][ \t]*+(?:\'[^\n]*+)?\n)*((?:(?:\'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)++|(?!(?:[Rr][Ee][Mm]\\b|REM[A-Z][a-z]))[A-Za-z_][A-Za-z0-9_]*+(?!\\.[0-9])|[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++|(?:0[xX][0-9a-fA-F]++|0[bB][01]++|(?:[0-9]++\\.?[0-9]*+|\\.[0-9]++)(?:[eE][+-]?[0-9]++)?+)(?![A-Za-z0-9_])|"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"|`(?:[^`\\\\\n]|\\\\[^\n])`|(?:/|\\\\)|<<|<=|<>|>=|>>|"[^\\n]*|[0-9][A-Za-z0-9_]*|.)'

LITERALS = {
    '!': 'COMPLEMENT',
    '#': 'HASH',
    '%': 'MOD',
    '&': 'AMPERSAND',
    '(': 'LPAR',
    ')': 'RPAR',
    '*': 'STAR',
    '+': 'PLUS',
    ',': 'COMMA',
    '-': 'MINUS',
    '.': 'DOT',
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
    '_NL': "(?:(?:'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)++",
    'NAME': '(?!(?:[Rr][Ee][Mm]\\b|REM[A-Z][a-z]))[A-Za-z_][A-Za-z0-9_]*+(?!\\.[0-9])',
    'DOTTED': '[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++',
    'NUMBER': '(?:0[xX][0-9a-fA-F]++|0[bB][01]++|(?:[0-9]++\\.?[0-9]*+|\\.[0-9]++)(?:[eE][+-]?[0-9]++)?+)(?![A-Za-z0-9_])',
    'STRING': '"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"',
    'CHARACTER': '`(?:[^`\\\\\n]|\\\\[^\n])`',
    'DIVIDE': '(?:/|\\\\)',
}

SPELLINGS = {
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
    'CIRCUMFLEX': '^',
    'VBAR': '|',
    'AMPERSAND': '&',
}

RULES = (
    (3, 'or{atom}', _xor_0),
    (6, 'closed_if', _line_if_else_1),
    (3, 'parameters', _inner_2),
    (3, 'inline_statement', _dim_3),
    (1, 'formats', _one_4),
    (2, 'end_while', _first_5),
    (1, 'end_loop', None),
    (1, 'word', None),
    (3, 'print_last', _last_using_6),
    (3, 'or{operand}', _xor_0),
    (10, 'inline_statement', _for_7),
    (1, 'leading', None),
    (3, 'compare{atom}', _binary_8),
    (5, 'inline_statement', _input_9),
    (1, 'leading', None),
    (6, 'declaration', _user_type_10),
    (6, 'parameter', _parameter_by_value_11),
    (3, 'items', _more_12),
    (3, 'shift{operand}', _binary_8),
    (3, 'ref{name{NAME}}', _member_13),
    (3, 'compare{operand}', _binary_8),
    (3, 'case', _case_else_14),
    (1, 'leading', None),
    (0, 'body', _body_15),
    (1, 'name{NAME}', _name_16),
    (2, 'parameter', _parameter_by_value_17),
    (4, 'inline_statement', _const_18),
    (1, 'inline_statement', _end_19),
    (3, 'term{atom}', _mod_20),
    (3, 'sum{atom}', _binary_8),
    (3, 'bit_and{atom}', _binary_8),
    (5, 'inline_statement', _repeat_21),
    (3, 'case', _case_22),
    (1, 'end_loop', None),
    (1, 'bit_or{operand}', None),
    (3, 'or{operand}', _or_23),
    (9, 'inline_statement', _input_24),
    (3, 'bit_or{atom}', _binary_8),
    (5, 'declaration', _startup_25),
    (1, 'leading', None),
    (1, 'bit_and{operand}', None),
    (4, 'inline_statement', _loop_26),
    (3, 'task_body', _more_12),
    (1, 'operand', _number_27),
    (3, 'shift{atom}', _binary_8),
    (2, 'parameter', _parameter_by_reference_28),
    (1, 'variable', None),
    (2, 'inline_statement', _run_29),
    (1, 'end_while', None),
    (1, 'name{leading}', _name_16),
    (2, 'end_loop', _first_5),
    (3, 'compare{atom}', _binary_8),
    (3, 'items', _more_12),
    (1, 'line_tail', _one_4),
    (3, 'and{atom}', _and_30),
    (1, 'line_tail', None),
    (1, 'closed', None),
    (1, 'end_while', None),
    (1, 'leading', None),
    (1, 'end_while', None),
    (1, 'power{operand}', None),
    (2, 'body', _label_before_31),
    (5, 'inline_statement', _while_32),
    (1, 'or{operand}', None),
    (3, 'or{atom}', _or_23),
    (3, 'exprs', _more_33),
    (3, 'print_list', _print_item_34),
    (6, 'if_tail', _else_if_35),
    (1, 'ref{name{leading}}', None),
    (3, 'task_body', _more_12),
    (1, 'leading', None),
    (4, 'inline_statement', _assign_36),
    (3, 'ref{name{leading}}', _member_13),
    (1, 'name{word}', _name_16),
    (3, 'members', _extend_37),
    (1, 'test', _test_38),
    (0, 'print_list', _none_39),
    (3, 'sum{operand}', _binary_8),
    (9, 'inline_statement', _input_24),
    (4, 'select', _last_case_40),
    (3, 'items', _more_12),
    (1, 'target', None),
    (3, 'body', _more_12),
    (7, 'routine', _function_41),
    (2, 'task_body', _label_before_31),
    (1, 'leading', None),
    (1, 'target', None),
    (1, 'call', None),
    (3, 'inline_statement', _print_42),
    (1, 'print_last', _last_item_43),
    (4, 'name{word}', _name_args_44),
    (4, 'if_tail', _third_45),
    (3, 'items', _more_12),
    (11, 'inline_statement', _for_46),
    (3, 'body', _more_12),
    (3, 'and{operand}', _and_30),
    (1, 'unary{operand}', None),
    (4, 'name{word}', _name_axes_47),
    (1, 'variable', None),
    (1, 'leading', None),
    (1, 'closed', _one_4),
    (1, 'tests', _one_4),
    (3, 'members', _extend_37),
    (5, 'select_head', _select_48),
    (6, 'if_tail', _else_if_35),
    (3, 'power{operand}', _binary_8),
    (2, 'items', _first_5),
    (1, 'inline', _one_4),
    (0, 'items', _none_39),
    (1, 'bare', _one_4),
    (6, 'parameter', _parameter_by_reference_49),
    (9, 'inline_statement', _for_50),
    (3, 'term{operand}', _binary_8),
    (3, 'open_dims', _more_33),
    (1, 'start', _module_51),
    (3, 'compare{operand}', _binary_8),
    (3, 'open_dims', _more_values_52),
    (4, 'members', _extend_53),
    (6, 'ref{name{leading}}', _member_args_54),
    (3, 'closed_dims', _plain_more_55),
    (3, 'sum{operand}', _binary_8),
    (1, 'leading', None),
    (3, 'inline_statement', _assign_56),
    (3, 'bit_or{operand}', _binary_8),
    (3, 'body', _more_12),
    (3, 'name{word}', _name_empty_57),
    (1, 'parameter_list', _one_4),
    (3, 'closed_dims', _more_33),
    (3, 'bit_and{operand}', _binary_8),
    (3, 'closed_dims', _more_33),
    (1, 'parameter', _parameter_58),
    (1, 'member_list', _one_4),
    (3, 'select_head', _next_case_59),
    (4, 'inline_statement', _input_60),
    (5, 'inline_statement', _print_61),
    (4, 'line_if', _line_if_62),
    (0, 'parameters', _none_39),
    (1, 'declared', _name_16),
    (3, 'valued', _valued_variable_63),
    (2, 'parameters', _none_64),
    (3, 'term{operand}', _binary_8),
    (1, 'term{operand}', None),
    (1, 'shift{operand}', None),
    (4, 'inline_statement', _input_65),
    (1, 'operand', None),
    (3, 'power{atom}', _binary_8),
    (1, 'exit_kind', None),
    (3, 'atom', _inner_2),
    (3, 'open_dims', _more_33),
    (1, 'exit_kind', None),
    (1, 'operand', _character_66),
    (2, 'inline_statement', _bare_call_67),
    (3, 'member_list', _more_33),
    (2, 'task_body', _first_5),
    (3, 'parameter', _parameter_68),
    (1, 'exit_kind', None),
    (3, 'sum{atom}', _binary_8),
    (1, 'ref{name{NAME}}', None),
    (1, 'call', None),
    (1, 'sep', None),
    (1, 'type', _type_69),
    (1, 'operand', _string_70),
    (3, 'bare', _more_33),
    (1, 'sep', None),
    (4, 'inline_statement', _define_71),
    (4, 'inline_statement', _input_60),
    (1, 'leading', None),
    (2, 'body', _first_5),
    (3, 'term{operand}', _mod_20),
    (4, 'name{leading}', _name_axes_47),
    (3, 'formats', _pair_72),
    (1, 'axes', _dotted_73),
    (0, 'task_body', _body_15),
    (2, 'unary{atom}', _minus_74),
    (1, 'word', None),
    (1, 'term{atom}', None),
    (6, 'statement', _if_75),
    (4, 'print_last', _last_open_76),
    (3, 'name{leading}', _name_empty_57),
    (2, 'else_if', _first_5),
    (2, 'end_if', _first_5),
    (1, 'and{atom}', None),
    (1, 'shift{atom}', None),
    (1, 'exit_kind', None),
    (1, 'exit_kind', None),
    (3, 'line_tail', _more_33),
    (1, 'leading', None),
    (2, 'inline_statement', _exit_77),
    (2, 'inline_statement', _input_78),
    (12, 'inline_statement', _for_79),
    (1, 'exit_kind', None),
    (3, 'items', _more_12),
    (1, 'bit_or{atom}', None),
    (1, 'if_tail', _none_80),
    (1, 'exit_kind', None),
    (4, 'parameter', _parameter_by_reference_81),
    (1, 'exit_kind', None),
    (3, 'parameter_list', _more_33),
    (3, 'test', _test_range_82),
    (1, 'exit_kind', None),
    (2, 'inline_statement', _goto_83),
    (1, 'inline_statement', None),
    (6, 'ref{name{NAME}}', _member_args_54),
    (3, 'test', _test_is_84),
    (6, 'line_if', _line_if_else_1),
    (1, 'print', None),
    (3, 'ref{name{word}}', _member_13),
    (9, 'routine', _function_85),
    (1, 'expr', None),
    (3, 'inline_statement', _goto_86),
    (6, 'declaration', _event_87),
    (4, 'declared', _name_args_44),
    (1, 'sum{atom}', None),
    (1, 'bit_and{atom}', None),
    (2, 'inline_statement', _pause_88),
    (3, 'term{atom}', _binary_8),
    (5, 'parameter', _parameter_89),
    (6, 'select', _select_nothing_90),
    (5, 'valued', _typed_variable_91),
    (1, 'dims', None),
    (1, 'not{operand}', None),
    (1, 'compare{operand}', None),
    (3, 'type', _sized_type_92),
    (1, 'compare{atom}', None),
    (6, 'inline_statement', _const_93),
    (1, 'unary{atom}', None),
    (1, 'ref{name{word}}', None),
    (3, 'tests', _more_33),
    (1, 'declaration', None),
    (2, 'inline_statement', _gosub_94),
    (6, 'inline_statement', _input_95),
    (2, 'inline_statement', _dim_96),
    (6, 'inline_statement', _input_95),
    (3, 'closed', _more_33),
    (3, 'inline', _more_33),
    (1, 'not{atom}', None),
    (7, 'inline_statement', _input_97),
    (3, 'typed', _variable_98),
    (3, 'task_body', _more_12),
    (3, 'task_body', _more_12),
    (4, 'parameter', _parameter_by_reference_99),
    (2, 'unary{operand}', _complement_100),
    (7, 'routine', _sub_101),
    (1, 'inline_statement', _auto_102),
    (3, 'task_body', _more_12),
    (2, 'not{operand}', _not_103),
    (3, 'parameter', _parameter_104),
    (2, 'unary{operand}', _plus_105),
    (7, 'print_list', _print_using_two_106),
    (2, 'items', _label_before_31),
    (1, 'inline_statement', _return_107),
    (2, 'unary{operand}', _minus_74),
    (1, 'inline_statement', _exit_108),
    (4, 'members', _extend_53),
    (1, 'inline_statement', _call_109),
    (1, 'statement', None),
    (1, 'else_if', None),
    (5, 'print_list', _print_using_110),
    (2, 'unary{atom}', _complement_100),
    (1, 'leading', None),
    (1, 'power{atom}', None),
    (4, 'parameter', _parameter_by_value_111),
    (1, 'or{atom}', None),
    (1, 'closed_dims', _plain_one_112),
    (7, 'inline_statement', _input_113),
    (1, 'dims', None),
    (1, 'exprs', _one_4),
    (0, 'members', _none_39),
    (4, 'parameter', _parameter_by_value_114),
    (1, 'target', None),
    (6, 'ref{name{word}}', _member_args_54),
    (2, 'unary{atom}', _plus_105),
    (3, 'test', _test_is_84),
    (7, 'print_list', _print_using_two_106),
    (3, 'inline_statement', _gosub_115),
    (1, 'and{operand}', None),
    (2, 'inline_statement', _label_116),
    (1, 'atom', None),
    (3, 'term{atom}', _binary_8),
    (1, 'closed_dims', _one_4),
    (1, 'sum{operand}', None),
    (6, 'declaration', _task_117),
    (1, 'print', None),
    (1, 'open_dims', _one_4),
    (1, 'end_if', None),
    (4, 'name{NAME}', _name_args_44),
    (3, 'name{NAME}', _name_empty_57),
    (2, 'inline_statement', _print_118),
    (3, 'print_list', _print_item_34),
    (4, 'name{NAME}', _name_axes_47),
    (6, 'inline_statement', _print_119),
    (6, 'statement', _if_75),
    (2, 'seps', _first_5),
    (2, 'not{atom}', _not_103),
    (2, 'inline_statement', _end_120),
    (7, 'inline_statement', _input_97),
    (1, 'seps', _none_80),
    (4, 'name{leading}', _name_args_44),
    (1, 'leading', None),
)

ROWS = (
    '353=EQUAL',
    '496=AND d0',
    '187=declared 206=typed 239=valued 390=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd1',
    'd2',
    'd3',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 535=END 544=select_head 547=target',
    '286=COMMA 458=SEMICOLON d4',
    'd5',
    'd6',
    'd7',
    'd8',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 253=exprs 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 477=expr',
    '496=AND d9',
    'd10',
    '74=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d11',
    '352=SHIFT d12',
    '224=USING d13',
    'd14',
    '50=BYVAL 189=BYREF 207=AUTO,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 324=parameter',
    'd15',
    '118=TO',
    'd16',
    'd17',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 75=ENDW 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 80=END 85=WEND 88=ENDWHILE 90=_NL 92=end_while 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    '293=MINUS 501=PLUS d18',
    '255=LPAR d19',
    '347=COMMA 479=SEMICOLON',
    '352=SHIFT d20',
    'd21',
    'd22',
    '438=body d23',
    '49=bit_and{operand} 65=compare{operand} 70=NUMBER 86=NOT 93=and{operand},not{operand} 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 170=or{operand} 228=axes,operand,power{operand},unary{operand},variable 229=sum{operand} 243=CHARACTER 244=bare 260=STRING 279=DOTTED 333=COMPLEMENT 379=bit_or{operand} 386=shift{operand} 420=LSQB 451=LPAR 482=MINUS 498=PLUS 512=term{operand} d24',
    '38=AS 242=LPAR d25',
    'd26',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 176=expr 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    '78=LOOP 541=NAME d27',
    '247=RPAR',
    '259=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 488=type',
    '357=FUNCTION 541=NAME d27',
    '309=CIRCUMFLEX d28',
    '200=DIVIDE 265=STAR 481=MOD d29',
    '341=COMPARE 523=EQUAL d30',
    'd31',
    '31=COLON,_NL,sep',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 241=END 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 131=END 135=axes 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    'd32',
    'd33',
    '411=AMPERSAND d34',
    '33=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d22',
    '496=AND d35',
    '43=expr 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    'd36',
    '490=AMPERSAND d37',
    '245=typed 269=declared 390=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd38',
    '15=RUN 32=NAME 52=UNTIL 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 432=END 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    '51=and{atom},not{atom} 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom}',
    '371=SELECT',
    '448=seps 545=COLON,_NL,sep',
    '130=COMMA 339=RPAR',
    '20=TYPE',
    '29=COLON,_NL,sep',
    '27=STRING 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 185=HASH 279=DOTTED 306=axes,variable d39',
    '142=EQUAL 454=COMPARE d40',
    'd41',
    'd42',
    '275=COLON,_NL,sep',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 316=exprs 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 477=expr',
    'd43',
    '293=MINUS 501=PLUS d44',
    '367=AS 429=LPAR d45',
    'd46',
    'd47',
    'd48',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 98=if_tail 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 317=end_if 321=END 330=HASH 331=ELSE 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 407=ELSEIF,else_if 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 518=ENDIF 544=select_head 547=target',
    '69=LSQB 263=LPAR d49',
    'd50',
    '352=SHIFT d51',
    '8=WHILE 541=NAME d27',
    'd52',
    'd53',
    'd54',
    '361=COLON r55=_NL d56',
    'd57',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 433=not{atom}',
    '204=COLON,_NL,sep d58',
    'd59',
    'd60',
    'd61',
    '130=COMMA 138=RPAR',
    'd62',
    '408=AND d63',
    '496=AND d64',
    'd65',
    '223=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd66',
    'd67',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 285=if_tail 296=REPEAT 298=FOR 317=end_if 321=END 330=HASH 331=ELSE 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 407=ELSEIF,else_if 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 518=ENDIF 544=select_head 547=target',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 192=exprs 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 477=expr',
    '120=AS 281=COLON,_NL,sep',
    'd68',
    'd69',
    'd70',
    'd71',
    '314=LPAR d72',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 127=_NL 135=axes 145=DIM 171=IF 216=WHILE 222=routine 246=COLON 248=END 254=name{NAME} 256=line_if 272=inline_statement,select,statement 276=FUNCTION 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 440=RETURN 441=SUB 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    '290=SEMICOLON 294=COMMA',
    '464=EQUAL 528=COMPARE',
    '381=LSQB 399=LPAR d73',
    '474=ELSE',
    'd74',
    '182=TO d75',
    '311=HASH 521=print_list d76',
    '200=DIVIDE 265=STAR 481=MOD d77',
    'd11',
    'd78',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 416=expr 469=and{atom},not{atom}',
    'd79',
    '154=type 259=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd80',
    '47=COLON,_NL,sep 297=COMMA',
    '197=DOT d81',
    'd82',
    'd83',
    '50=BYVAL 189=BYREF 193=parameter_list 202=parameter 207=AUTO,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 221=RPAR',
    'd84',
    'd58',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 396=expr 406=bit_or{atom} 469=and{atom},not{atom}',
    '70=NUMBER 95=expr 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    '360=EVENT 541=NAME d27',
    '252=COMMA',
    'd85',
    '53=formats 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 167=expr 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    'r86=EQUAL d87',
    'd88',
    '97=COMMA 160=USING 526=SEMICOLON d89',
    'd90',
    'd91',
    'd92',
    '310=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d93',
    '28=shift{atom} 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom}',
    'd94',
    '196=body d23',
    '375=closed_dims 390=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 401=dims 471=declared 473=open_dims 495=NV 511=typed 517=valued',
    'd95',
    '76=body d23',
    'd96',
    'd97',
    '419=DOT d98',
    'd99',
    'd100',
    'd101',
    '484=COLON,_NL,sep',
    'd102',
    '54=bit_and{atom} 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom} 366=compare{atom} 389=shift{atom}',
    'd103',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 373=expr 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 385=exprs 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 477=expr',
    '7=expr 11=formats 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    '6=body d23',
    'd104',
    'd105',
    'd106',
    '259=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 434=type',
    'd107',
    '129=COMMA d4',
    '143=_NL',
    '179=items 236=start d108',
    '58=OR 417=XOR d109',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 456=expr 469=and{atom},not{atom}',
    'd110',
    '17=axes,variable 108=STRING 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 279=DOTTED',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 480=END 489=ref{name{NAME}} 544=select_head 547=target',
    '14=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d111',
    '258=THEN',
    '309=CIRCUMFLEX d112',
    'd113',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,NV,STEP,TO,USING,leading 87=STARTUP 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 164=COLON 171=IF 216=WHILE 254=name{NAME} 271=TYPE 276=FUNCTION 279=DOTTED 296=REPEAT 298=FOR 304=EVENT 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 424=declaration,routine 430=AUTO 432=END 437=_NL 440=RETURN 441=SUB 443=EXIT 446=call 457=inline_statement,select,statement 461=TASK 476=GOTO 489=ref{name{NAME}} 525=line_if 544=select_head 547=target d114',
    '352=SHIFT d115',
    '352=SHIFT d116',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 326=expr 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    'd117',
    '329=AS 492=EQUAL',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 508=expr',
    'd118',
    '329=AS 492=EQUAL d119',
    '200=DIVIDE 265=STAR 481=MOD d120',
    '72=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d121',
    '63=ELSE 70=NUMBER 109=IS 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 113=expr 122=tests 150=name{word},ref{name{word}} 153=test 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    '130=COMMA 149=RSQB',
    '105=SEMICOLON 130=COMMA d122',
    '4=RPAR 19=COMMA',
    '486=seps 545=COLON,_NL,sep',
    '490=AMPERSAND d123',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 317=end_if 321=END 330=HASH 331=ELSE 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 407=ELSEIF,else_if 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 518=ENDIF 533=if_tail 544=select_head 547=target',
    '106=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd124',
    '55=COMMA 112=COLON 155=_NL',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR 510=atom,axes,operand,power{atom},unary{atom},variable',
    'd125',
    'd126',
    'd127',
    '45=body d23',
    '341=COMPARE 523=EQUAL d128',
    'd129',
    '37=LPAR 165=AS d130',
    'd131',
    'd132',
    '280=COLON,_NL,sep',
    '414=USING d133',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 137=expr 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 530=print_last d134',
    'd135',
    '208=typed 269=declared 307=member_list 390=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '130=COMMA 186=RPAR',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 325=expr 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    '124=COLON 198=_NL',
    '126=LPAR 238=parameters d136',
    '381=LSQB 504=LPAR r137=AS,EQUAL d73',
    'd138',
    'd139',
    '415=COLON 423=_NL',
    '463=EQUAL',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 167=expr 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 472=formats',
    '101=parameters 126=LPAR d136',
    '292=EQUAL',
    '309=CIRCUMFLEX d140',
    '452=CIRCUMFLEX d141',
    '421=MINUS 425=PLUS d142',
    'd143',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 167=expr 230=formats 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    'd144',
    'd145',
    'd146',
    'd147',
    '',
    '34=expr 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    '161=COLON,_NL,sep',
    'd148',
    'd149',
    '56=STARTUP 541=NAME d27',
    '468=RPAR',
    'd150',
    '422=COMMA d151',
    'd152',
    'd153',
    '540=AS d154',
    '514=TASK 541=NAME d27',
    'd155',
    '200=DIVIDE 265=STAR 481=MOD d156',
    '57=body d23',
    '212=print_list d76',
    '130=COMMA 364=RPAR',
    'r157=DOT,EQUAL d158',
    '61=exprs 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 477=expr',
    '431=_NL',
    'd159',
    '15=RUN 32=NAME 35=IF 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 82=line_if 84=inline 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 152=closed_if 166=inline_statement,select 213=line_tail 216=WHILE 254=name{NAME} 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 432=END 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 537=closed 544=select_head 547=target',
    '382=STAR d160',
    'd161',
    '119=SELECT 541=NAME d27',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 274=atom,axes,operand,power{atom},unary{atom},variable 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 288=RPAR 299=exprs 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 477=expr',
    '99=body d23',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR 369=atom,axes,operand,power{atom},unary{atom},variable',
    'd162',
    'd163',
    'd164',
    '410=AS',
    '404=USING d165',
    '194=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d166',
    '67=COLON 103=_NL',
    'd167',
    '309=CIRCUMFLEX d168',
    '513=body d23',
    '225=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd169',
    '436=COMMA 497=SEMICOLON d170',
    'd171',
    '107=task_body d172',
    '174=body d23',
    'd173',
    'd174',
    '309=CIRCUMFLEX d175',
    'd176',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 278=expr 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} d177',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 282=atom,axes,operand,unary{atom},variable 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR',
    'd178',
    'd179',
    '110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 279=DOTTED 409=axes,variable',
    'd180',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 391=expr 406=bit_or{atom} 469=and{atom},not{atom}',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 250=term{atom} 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR',
    '110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 279=DOTTED 543=axes,variable',
    'd181',
    '251=COLON,_NL,sep',
    '70=NUMBER 109=IS 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 113=expr 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 395=test 406=bit_or{atom} 469=and{atom},not{atom}',
    '0=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '130=COMMA 546=RPAR',
    '293=MINUS 501=PLUS d182',
    'd183',
    'd184',
    'd185',
    '344=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d186',
    'd187',
    '231=USING d188',
    '55=COMMA 183=COLON 445=_NL',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 227=atom,axes,operand,power{atom},unary{atom},variable 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 233=atom,axes,operand,unary{atom},variable 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR',
    'd189',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 132=expr 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    'd190',
    'd191',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 215=exprs 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 477=expr',
    '490=AMPERSAND d192',
    '130=COMMA 277=RSQB',
    'd193',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 117=formats 150=name{word},ref{name{word}} 167=expr 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    'd194',
    '351=AS d195',
    '291=IF 541=NAME d27',
    'd196',
    '70=NUMBER 94=and{atom},not{atom} 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom}',
    'd197',
    '542=COLON,_NL,sep',
    'd198',
    'd199',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR 493=atom,axes,operand,unary{atom},variable',
    '259=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 412=type',
    '507=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '289=IF 483=COLON,_NL,sep',
    '264=COLON,_NL,sep',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR 427=atom,axes,operand,unary{atom},variable',
    '60=expr 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    'd200',
    '478=THEN',
    'd201',
    '1=and{atom},not{atom} 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom}',
    'd202',
    'd203',
    '16=shift{atom} 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom}',
    '359=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR 459=atom,axes,operand,unary{atom},variable',
    '487=COLON,_NL,sep',
    'd204',
    'd205',
    '110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 270=axes,variable 279=DOTTED',
    '147=COLON,_NL,sep',
    '398=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 531=HASH',
    '159=LPAR d206',
    '172=type 259=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '70=NUMBER 71=sum{atom} 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom}',
    '21=expr 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 532=expr',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 336=expr 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    '334=CASE',
    'd207',
    '323=OR 338=XOR d208',
    'd209',
    'd210',
    '15=RUN 32=NAME 35=IF 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 216=WHILE 254=name{NAME} 279=DOTTED 296=REPEAT 298=FOR 303=line_if 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 403=closed_if 405=inline_statement,select 430=AUTO 432=END 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    'r211=AS,EQUAL d90',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 368=expr 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    'd211',
    '200=DIVIDE 265=STAR 481=MOD d212',
    '341=COMPARE 523=EQUAL d213',
    '259=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 426=type',
    'd214',
    '309=CIRCUMFLEX d215',
    'd216',
    'd217',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 168=line_if 171=IF 190=CASE 209=case 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 261=END 273=COLON 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    'd218',
    '470=body d23',
    '2=COMMA d219',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 139=end_if 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 321=END 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 518=ENDIF 544=select_head 547=target',
    '3=closed 15=RUN 32=NAME 35=IF 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 82=line_if 84=inline 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 152=closed_if 166=inline_statement,select 216=WHILE 254=name{NAME} 279=DOTTED 296=REPEAT 298=FOR 330=HASH 345=line_tail 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 432=END 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    '26=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '455=VBAR d220',
    '237=EQUAL 439=AS',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 191=exprs 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 477=expr',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR 388=atom,axes,operand,unary{atom},variable',
    '380=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd39',
    '130=COMMA 491=RPAR',
    '467=SHIFT d221',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 539=not{atom}',
    'd222',
    '352=SHIFT d223',
    '12=LPAR d137',
    'd224',
    'd225',
    'd226',
    '62=END 199=member_list 208=typed 214=DIM 269=declared 390=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd227',
    'd170',
    'd228',
    'd229',
    '70=NUMBER 91=exprs 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 201=RPAR 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 477=expr',
    'd230',
    'd231',
    'd232',
    'd233',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 167=expr 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 402=formats 406=bit_or{atom} 469=and{atom},not{atom}',
    'd234',
    '156=VBAR d235',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 475=expr',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 146=not{atom} 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom}',
    '318=USING d236',
    '259=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 499=type',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 205=compare{atom} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom} 389=shift{atom}',
    '158=EQUAL d237',
    '70=NUMBER 150=name{word},ref{name{word}} 178=valued 181=shift{atom} 184=declared 203=typed 219=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom}',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 167=expr 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 400=formats 406=bit_or{atom} 469=and{atom},not{atom}',
    'd238',
    '374=COLON,_NL,sep 500=STEP',
    '13=and{atom},not{atom} 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom}',
    '505=COLON,_NL,sep',
    '350=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 477=expr 506=exprs',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 115=term{atom} 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 266=expr 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    'd239',
    '121=COLON 313=_NL',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 188=term{atom} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR',
    'd240',
    'd241',
    'd242',
    '320=RPAR',
    'r243=COLON,ELSE,_NL d14',
    'd244',
    '541=NAME d27',
    'd245',
    'd246',
    'd247',
    'd248',
    'd249',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 141=NEXT 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 432=END 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    '226=type 259=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd250',
    '218=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd251',
    '305=EVENT,FOR,FUNCTION,LOOP,REPEAT,SELECT,SUB,TASK,WHILE,exit_kind d252',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 177=atom,axes,operand,power{atom},unary{atom},variable 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR',
    'd253',
    'd254',
    'd121',
    '59=END 157=case 190=CASE 538=COLON,_NL,sep',
    'd255',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 216=WHILE 254=name{NAME} 279=DOTTED 296=REPEAT 298=FOR 303=line_if 330=HASH 349=GOSUB 355=IF 356=SELECT 363=PAUSE 383=CONST 405=inline_statement,select 430=AUTO 432=END 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 477=expr 520=RPAR 527=exprs',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 163=atom,axes,operand,unary{atom},variable 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR',
    'd256',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 180=shift{atom} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom}',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 195=bit_and{atom} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom} 366=compare{atom} 389=shift{atom}',
    '332=DO 460=THEN',
    '23=COLON 81=_NL',
    'd257',
    'd258',
    '15=RUN 32=NAME 35=IF 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 82=line_if 84=inline 96=DEFINE 111=closed 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 144=_NL 145=DIM 152=closed_if 166=inline_statement,select 213=line_tail 216=WHILE 254=name{NAME} 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 432=END 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    '210=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d85',
    'd259',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 268=expr 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 340=expr 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    '450=COLON d55',
    'd260',
    '25=sum{atom} 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom}',
    '534=AS d261',
    '496=AND d262',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 168=line_if 171=IF 175=NEXT 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 432=END 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    '329=AS 492=EQUAL d263',
    'd264',
    '413=COMMA d265',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 82=line_if 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 166=inline_statement,select 216=WHILE 254=name{NAME} 279=DOTTED 296=REPEAT 298=FOR 330=HASH 345=line_tail 349=GOSUB 355=IF 356=SELECT 363=PAUSE 383=CONST 430=AUTO 432=END 440=RETURN 443=EXIT 446=call 465=inline 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    '348=DO 418=THEN',
    '335=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 342=HASH',
    'd266',
    '15=RUN 32=NAME 35=IF 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 82=line_if 84=inline 96=DEFINE 111=closed 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 152=closed_if 166=inline_statement,select 213=line_tail 216=WHILE 254=name{NAME} 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 432=END 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    '110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 211=axes,variable 279=DOTTED',
    '125=FUNCTION 541=NAME d27',
    '40=atom,axes,operand,power{atom},unary{atom},variable 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR 442=atom,axes,operand,unary{atom},variable',
    '376=body d23',
    '522=body d23',
    'd186',
    '394=members 538=COLON,_NL,sep d267',
    '46=body d23',
    'd268',
    '378=DOT d269',
    '42=compare{atom} 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom} 389=shift{atom}',
    'd270',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 220=expr 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    'd271',
    'd272',
    '5=dims 375=closed_dims 390=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 471=declared 473=open_dims 511=typed 517=valued d259',
    '70=NUMBER 83=not{atom} 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom}',
    'd273',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR 435=atom,axes,operand,unary{atom},variable',
    'd237',
    '44=expr 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom}',
    '41=term{atom} 70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 328=PLUS 343=COMPLEMENT 354=LPAR',
    'd274',
    'd275',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 201=RPAR 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 477=expr 524=exprs',
    '516=body d23',
    '130=COMMA 529=RSQB',
    'd276',
    '173=COMMA',
    'd277',
    '309=CIRCUMFLEX d278',
    'd279',
    '262=MOD 308=DIVIDE 444=STAR d280',
    '9=ENDL 15=RUN 32=NAME 36=END 48=ENDLOOP 64=INPUT 66=end_loop 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    'd281',
    'd282',
    '15=RUN 32=NAME 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 162=if_tail 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 317=end_if 321=END 330=HASH 331=ELSE 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 407=ELSEIF,else_if 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 518=ENDIF 544=select_head 547=target',
    'd283',
    'd284',
    'd285',
    'd286',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 136=print_last 137=expr 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} d287',
    '15=RUN 32=NAME 39=END 64=INPUT 68=LOOP 77=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 90=_NL 96=DEFINE 114=PRINT,QMARK,print 123=name{leading},ref{name{leading}} 135=axes 145=DIM 168=line_if 171=IF 216=WHILE 217=inline_statement,select,statement 254=name{NAME} 273=COLON 279=DOTTED 296=REPEAT 298=FOR 330=HASH 349=GOSUB 356=SELECT 363=PAUSE 383=CONST 430=AUTO 440=RETURN 443=EXIT 446=call 476=GOTO 489=ref{name{NAME}} 544=select_head 547=target',
    '70=NUMBER 79=shift{atom} 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 365=term{atom}',
    '130=COMMA 362=RPAR',
    '140=_NL',
    'd288',
    '130=COMMA 519=RPAR',
    '70=NUMBER 110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 150=name{word},ref{name{word}} 243=CHARACTER 260=STRING 279=DOTTED 284=atom,axes,operand,power{atom},unary{atom},variable 287=MINUS 300=sum{atom} 315=bit_and{atom} 328=PLUS 343=COMPLEMENT 354=LPAR 358=or{atom} 365=term{atom} 366=compare{atom} 387=NOT 389=shift{atom} 406=bit_or{atom} 469=and{atom},not{atom} 494=expr',
    'd289',
    'd290',
    '502=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '235=RPAR',
    'd291',
    '22=type 259=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '428=SUB 541=NAME d27',
    'd166',
    '377=ELSE',
    'd292',
    'd293',
    '259=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 370=type',
    'd294',
    '24=body d23',
    '134=USING d295',
    '372=body d23',
    'd296',
    'd297',
    '100=EQUAL',
    'd298',
)

TABLES = Tables(TOKEN, CONTINUED, LITERALS, CLASSES, RULES, ROWS, 169, 236)
