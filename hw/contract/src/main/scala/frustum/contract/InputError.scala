package frustum.contract

final case class InputError(message: String) extends RuntimeException(message)
