"""A scene's XML, part by part."""


def parameter(name, kind, value):
    value = value.replace("&", "&amp;").replace("<", "&lt;")
    return '<Parameter name="%s" type="%s" value="%s"/>\n' % (name, kind, value)


def text(name, value):
    return parameter(name, "string", value)


def real(name, value):
    return parameter(name, "double", "%.9g" % value)


def sublist(name, inner):
    return '<ParameterList name="%s">\n%s</ParameterList>\n' % (name, inner)
